// Every widget of the Environment panel, dragged or clicked as a person does it: the picture changes with it, and so does the file.
#include "io/files/image_file.h"
#include "io/scene/fields.h"
#include "tests/cli/wold.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>
#include <span>

namespace test {
namespace {

struct Field {
    std::string key, label;
    std::vector<std::string> options; // to choose from
    double most = 0;                  // of a number
};

struct FieldList {
    const io::Value &texts, &values;
    std::string path;
    std::vector<Field>& all;

    template <class T> void operator()(const char* key, T& value, const io::Hint& hint)
    {
        if constexpr (requires(FieldList inner) { fields(inner, value); }) {
            FieldList inner{texts, values, path + key + ".", all};
            fields(inner, value);
        } else {
            Field field{.key = path + key, .label = text(texts, path + key), .most = hint.max};
            if constexpr (requires { enumNames(value); })
                for (const std::string_view name : enumNames(value))
                    field.options.push_back(text(values, name));
            all.push_back(field);
        }
    }
};

std::vector<Field> environmentFields()
{
    const io::Value english = json(textOf(WOLD_SOURCE_DIR "/app/lang/en.json"));
    std::vector<Field> all;
    io::Environment environment;
    FieldList list{*english.find("field"), *english.find("value"), "", all};
    fields(list, environment);
    return all;
}

// What must be so for a field to show: values of the environment and of drawing, and a tier that does not cap it.
struct Stage {
    std::vector<std::string> sets;
    std::vector<std::string_view> keys; // whole keys, or sections that end in a dot
    std::string quality = "medium";
};
const std::array<Stage, 12>& stages()
{
    static const std::array<Stage, 12> all{{
        {{"environment.sun.mode=manual", "environment.sun.azimuth=0", "environment.sun.elevation=9", "environment.clouds.coverage=0"}, // in view
         {"sun.azimuth", "sun.elevation", "sun.angular_diameter"}},
        {{"environment.time=0", "environment.moon.mode=manual", "environment.moon.azimuth=0", "environment.moon.elevation=9", "environment.clouds.coverage=0"},
         {"moon.", "sky.stars"}},
        {{"environment.clock=zone", "environment.time_zone=1", "environment.longitude=15"}, {"clock", "time_zone", "longitude", "year"}},
        {{"environment.shadows.splits=manual", "environment.shadows.end_1=12", "environment.shadows.end_2=16", "environment.shadows.end_3=20",
          "environment.shadows.end_4=25", "environment.shadows.end_5=30", "environment.shadows.cascades=6", "environment.shadows.distance=40",
          "environment.shadows.resolution=512", "render.ao=off"},
         {"shadows.splits", "shadows.end_", "shadows.cascades", "shadows.distance", "shadows.resolution", "shadows.fade"},
         "high"},
        {{"environment.auto_exposure.on=on", "environment.auto_exposure.highest=-1", "environment.auto_exposure.lowest=-3"}, {"auto_exposure.highest"}},
        {{"environment.auto_exposure.on=on", "environment.auto_exposure.lowest=5"}, {"auto_exposure.lowest"}},
        {{"environment.auto_exposure.on=on", "environment.auto_exposure.highest=20", "environment.time=0"}, {"auto_exposure.darkness"}},
        {{"environment.auto_exposure.on=on"}, {"auto_exposure."}},
        {{"environment.water.on=on", "environment.water.level=1.5", "environment.water.waves=0.5", "environment.water.wavelength=6"}, {"water."}},
        {{"render.cloud_kind=volume", "environment.clouds.coverage=0.6"}, {"clouds.thickness", "clouds.density", "clouds.kind"}},
        {{"render.froxels=on", "environment.fog.density=0.004"}, {"fog.shafts"}},
        {{}, {""}},
    }};
    return all;
}

const Stage& stageOf(const Field& field)
{
    return *std::ranges::find_if(stages(), [&](const Stage& stage) {
        return std::ranges::any_of(stage.keys, [&](std::string_view key) { return field.key.starts_with(key); });
    });
}

// These say how something goes on, not what a picture shows.
bool showsOnlyInTime(const Field& field)
{
    return field.key == "day_speed" || field.key == "day_runs" || field.key == "auto_exposure.seconds" || field.key == "clouds.speed" || field.key == "clouds.direction" ||
           field.key == "clouds.change" || field.key == "wind.gustiness";
}

constexpr std::size_t kAtOnce = 20; // fields of one replay, which has two minutes

struct Widget {
    std::string kind, value;
    double number = 0;
    std::array<int, 4> rect{}; // pixels: x, y, width, height
    std::string place() const { return fmt::format("[{}, {}]", rect[0] + rect[2] / 3, rect[1] + rect[3] / 2); }
};

std::vector<Widget> widgetsOf(const io::Value& map, const std::string& label)
{
    std::vector<Widget> found;
    for (const io::Value& item : *map.asArray()) {
        const std::string own = text(item, "label"), kind = text(item, "kind");
        const bool edits = kind == "number" || kind == "combo" || kind == "checkbox" || kind == "colour";
        if (text(item, "panel") != "environment" || !edits || (own != label && own != label + " X" && own != label + " Y" && own != label + " Z")) continue;
        Widget widget{.kind = kind};
        if (const io::Value* value = item.find("value")) {
            if (value->asString()) widget.value = *value->asString();
            if (value->asNumber()) widget.number = *value->asNumber();
        }
        for (std::size_t i = 0; i < 4; ++i)
            widget.rect[i] = int(*(*item.find("rect")->asArray())[i].asNumber());
        found.push_back(widget);
    }
    return found;
}

std::array<int, 4> viewportOf(const io::Value& map)
{
    std::array<int, 4> rect{};
    for (const io::Value& item : *map.asArray())
        if (text(item, "kind") == "viewport")
            for (std::size_t i = 0; i < 4; ++i)
                rect[i] = int(*(*item.find("rect")->asArray())[i].asNumber());
    return rect;
}

// Pixels of the viewport that differ.
int changedPixels(const std::string& before, const std::string& after, const std::array<int, 4>& viewport)
{
    const auto a = io::readImage(before), b = io::readImage(after);
    if (!a || !b || a->size != b->size || a->channels != b->channels) return -1;
    int changed = 0;
    for (int y = viewport[1]; y < viewport[1] + viewport[3]; ++y) {
        const auto *left = a->row<std::uint8_t>(y), *right = b->row<std::uint8_t>(y);
        for (int x = viewport[0]; x < viewport[0] + viewport[2]; ++x) {
            const int texel = x * a->channels;
            changed += !std::equal(left + texel, left + texel + 3, right + texel);
        }
    }
    return changed;
}

struct Light : SmallWorld {
    std::string base{R"({"do":"set","key":"environment.time","value":8}
{"do":"set","key":"environment.fog.density","value":0.0008}
{"do":"set","key":"environment.fog.height","value":40}
{"do":"set","key":"environment.clouds.coverage","value":0.45}
{"do":"set","key":"environment.weather.rain","value":3}
{"do":"set","key":"environment.sky.aerial","value":30}
)"};
    std::vector<std::string> words(const Stage& stage, const std::string& events, bool looked = false)
    {
        std::vector<std::string> all{"edit", project, "--replay", folder.write("events.jsonl", events), "--size", "800x520", "--quality", stage.quality, "--quiet"};
        std::vector<std::string> sets = stage.sets;
        if (!looked) // what is drawn does not matter
            for (const char* costly : {"shadows", "clouds", "ao", "particles", "water", "fog", "bloom"})
                sets.push_back(std::string{"render."} + costly + "=off");
        for (const std::string& set : sets) {
            all.emplace_back("--set");
            all.push_back(set);
        }
        return all;
    }
    static std::string search(const std::string& key)
    {
        return "{\"click\": {\"panel\": \"environment\", \"label\": \"Search settings\"}}\n{\"key\": \"Ctrl+A\"}\n{\"text\": \"" + key + "\"}\n{\"wait\": 2}\n";
    }
    static std::string use(const Field& field, const Widget& widget)
    {
        if (widget.kind == "colour") {
            const std::string picker = "{\"kind\": \"colour picker\", \"offset\": ";
            return "{\"click\": " + widget.place() + "}\n{\"wait\": 2}\n{\"drag\": {\"from\": " + picker + "[-60, -40]}, \"to\": " + picker +
                   "[-20, 10]}, \"steps\": 2}}\n{\"key\": \"Escape\"}\n{\"wait\": 1}\n";
        }
        const int by = widget.number < field.most ? 60 : -60; // pixels
        if (widget.kind == "number")
            return fmt::format("{{\"drag\": {{\"from\": {0}, \"to\": [{1}, {2}], \"steps\": 2}}}}\n{{\"wait\": 1}}\n", widget.place(), widget.rect[0] + widget.rect[2] / 3 + by,
                               widget.rect[1] + widget.rect[3] / 2);
        std::string other;
        if (widget.kind == "combo") {
            const auto option = std::ranges::find_if(field.options, [&](const std::string& one) { return one != widget.value; });
            other = "{\"wait\": 2}\n{\"click\": {\"kind\": \"option\", \"label\": \"" + *option + "\"}}\n";
        }
        return "{\"click\": " + widget.place() + "}\n" + other + "{\"wait\": 2}\n";
    }
    void lookAndKeep(const Stage& stage, std::span<const Field> own); // uses the widget of each
    io::Value saved() const { return json(textOf(project + "/environments/day.json")); }
};

const io::Value* valueAt(const io::Value& environment, std::string_view key)
{
    const std::size_t dot = key.find('.');
    const io::Value* value = environment.find(key.substr(0, dot));
    return value && dot != key.npos ? valueAt(*value, key.substr(dot + 1)) : value;
}

void Light::lookAndKeep(const Stage& stage, std::span<const Field> own)
{
    const std::string settled = "{\"wait\": 3}\n{\"click\": {\"kind\": \"tab\", \"label\": \"Environment\"}}\n{\"wait\": 2}\n";
    std::string events = settled;
    for (const Field& field : own)
        events += search(field.key) + "{\"uimap\": \"" + folder / (field.key + ".json") + "\"}\n";
    Ran ran = wold(words(stage, events));
    ASSERT_EQ(ran.code, 0) << ran.err;

    std::map<std::string, io::Value> maps;
    std::map<std::string, std::size_t> counts;
    std::string looked = settled, kept = settled, chosen, switched; // what chooses goes last, and what switches off after that: others may then have nothing to say
    for (const Field& field : own) {
        maps[field.key] = json(textOf(folder / (field.key + ".json")));
        const std::vector<Widget> widgets = widgetsOf(maps[field.key], field.label);
        ASSERT_FALSE(widgets.empty()) << field.key;
        const std::string way = search(field.key);
        std::string used;
        counts[field.key] = widgets.size(); // three where each axis has its own
        for (std::size_t i = 0; i < widgets.size(); ++i) {
            const std::string one = use(field, widgets[i]), file = field.key + std::to_string(i);
            looked += way + "{\"shot\": \"" + folder / (file + "-0.png") + "\"}\n" + one + "{\"shot\": \"" + folder / (file + "-1.png") + "\"}\n{\"key\": \"Ctrl+Z\"}\n{\"wait\": 1}\n";
            used += one;
        }
        const bool chooses = widgets.front().kind == "combo" || widgets.front().kind == "checkbox" || field.key == "shadows.cascades";
        const bool switches = field.key.ends_with(".on");
        (switches ? switched : chooses ? chosen : kept) += search(field.key) + used;
    }
    ran = wold(words(stage, looked, true));
    ASSERT_EQ(ran.code, 0) << ran.err;
    for (const Field& field : own) {
        if (showsOnlyInTime(field)) continue;
        for (std::size_t i = 0; i < counts[field.key]; ++i) {
            const std::string file = field.key + std::to_string(i);
            EXPECT_GT(changedPixels(folder / (file + "-0.png"), folder / (file + "-1.png"), viewportOf(maps[field.key])), 20) << file;
        }
    }
    const std::string before = textOf(project + "/environments/day.json"), save = "{\"key\": \"Ctrl+S\"}\n{\"wait\": 3}\n";
    ASSERT_EQ(wold(words(stage, settled + save)).code, 0);
    const io::Value then = saved();
    ran = wold(words(stage, kept + chosen + switched + save));
    ASSERT_EQ(ran.code, 0) << ran.err;
    const io::Value now = saved();
    for (const Field& field : own) {
        const io::Value *a = valueAt(now, field.key), *b = valueAt(then, field.key);
        ASSERT_TRUE(a && b) << field.key;
        EXPECT_FALSE(*a == *b) << field.key;
        for (std::size_t i = 0; counts[field.key] > 1 && i < counts[field.key]; ++i)
            EXPECT_FALSE((*a->asArray())[i] == (*b->asArray())[i]) << field.key << " " << i;
    }
    folder.write("world/environments/day.json", before);
}

TEST_F(Light, EachWidgetOfTheEnvironmentChangesPictureAndFile)
{
    ASSERT_EQ(wold({"run", project, "-", "--quiet"}, base + "{\"do\":\"save\"}\n").code, 0);
    const std::vector<Field> all = environmentFields();
    ASSERT_GT(all.size(), 60u);
    for (const Stage& stage : stages()) {
        std::vector<Field> staged;
        std::ranges::copy_if(all, std::back_inserter(staged), [&](const Field& field) { return &stageOf(field) == &stage; });
        for (std::size_t first = 0; first < staged.size(); first += kAtOnce)
            lookAndKeep(stage, std::span{staged}.subspan(first, std::min(kAtOnce, staged.size() - first)));
    }
}

// What shows only as time passes: the same half second with and without the widget used.
TEST_F(Light, WidgetsOfWhatDriftsChangeThePictureInTime)
{
    const std::vector<Field> all = environmentFields();
    const Stage stage{{"environment.clouds.coverage=0.5", "environment.clouds.speed=60", "environment.clouds.change=30", "environment.clouds.direction=10"}, {}};
    const std::string settled = "{\"wait\": 3}\n{\"click\": {\"kind\": \"tab\", \"label\": \"Environment\"}}\n{\"wait\": 2}\n";
    const auto later = [&](const std::string& file) { return "{\"key\": \"F4\"}\n{\"wait\": 30}\n{\"shot\": \"" + folder / file + "\"}\n"; };
    for (const char* key : {"clouds.speed", "clouds.direction", "clouds.change"}) {
        const Field field = *std::ranges::find(all, key, &Field::key);
        Ran ran = wold(words(stage, settled + search(key) + "{\"uimap\": \"" + folder / "map.json" + "\"}\n" + later("without.png"), true));
        ASSERT_EQ(ran.code, 0) << ran.err;
        const io::Value map = json(textOf(folder / "map.json"));
        const std::vector<Widget> widgets = widgetsOf(map, field.label);
        ASSERT_FALSE(widgets.empty()) << key;
        ran = wold(words(stage, settled + search(key) + use(field, widgets.front()) + later("with.png"), true));
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_GT(changedPixels(folder / "without.png", folder / "with.png", viewportOf(map)), 20) << key;
    }
}

TEST_F(Light, TheDialTakesTheSunAlong)
{
    const std::string settled = "{\"wait\": 3}\n{\"click\": {\"kind\": \"tab\", \"label\": \"Environment\"}}\n{\"wait\": 2}\n";
    const std::string dial = "{\"panel\": \"environment\", \"kind\": \"dial\", \"offset\": ";
    const std::string drag = "{\"drag\": {\"from\": " + dial + "[0, -30]}, \"to\": " + dial + "[30, 0]}, \"steps\": 4}}\n{\"wait\": 2}\n";
    const Stage plain{};
    const Ran ran = wold(words(plain, settled + "{\"uimap\": \"" + folder / "map.json" + "\"}\n{\"shot\": \"" + folder / "before.png" + "\"}\n" + drag + "{\"shot\": \"" + folder / "after.png" +
                                          "\"}\n{\"key\": \"Ctrl+S\"}\n{\"wait\": 3}\n", true));
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_GT(changedPixels(folder / "before.png", folder / "after.png", viewportOf(json(textOf(folder / "map.json")))), 1000);
    const io::Value now = saved();
    EXPECT_EQ(text(*now.find("sun"), "mode"), "manual");
    EXPECT_NEAR(number(*now.find("sun"), "azimuth"), 90, 3); // east is right
    EXPECT_GT(number(*now.find("sun"), "elevation"), 20);
}

} // namespace
} // namespace test
