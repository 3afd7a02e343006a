#include "app/option_words.h"

#include "app/text.h"
#include "io/base/log.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace app {
namespace {

constexpr std::array<std::string_view, 11> kCommands{"edit", "play", "render", "pick", "run", "bench", "check", "new", "info", "import", "export"};
constexpr std::array<std::string_view, 1> kLater{"merge"};
constexpr std::array<std::string_view, 5> kQualities{"auto", "low", "medium", "high", "ultra"};
constexpr int kLargestSide = 16384;
constexpr double kLargestPicture = 64e6; // pixels; the frame keeps about 50 bytes of each

glm::ivec2 sizeFrom(const std::string& text)
{
    const auto parts = split(text, 'x');
    const auto width = toNumber<int>(parts.front()), height = toNumber<int>(parts.back());
    if (parts.size() != 2 || !width || !height) throw wrong("--size", text, "write WIDTHxHEIGHT, as 1280x720");
    if (std::min(*width, *height) < 1 || std::max(*width, *height) > kLargestSide ||
        double(*width) * *height > kLargestPicture)
        throw wrong("--size", text, "each side is 1 to 16384 pixels, and the picture at most 64 million");
    return {*width, *height};
}

io::Camera viewFrom(const std::string& text)
{
    const auto n = toNumbers(text, ',');
    if (n.size() != 5 && n.size() != 6)
        throw wrong("--view", text, "write X,Y,Z,YAW,PITCH[,FOV] in metres and degrees");
    io::Camera camera{.name = "view", .eye = {n[0], n[1], n[2]}, .yaw = float(n[3]), .pitch = float(n[4])};
    if (n.size() == 6) camera.fov = float(n[5]);
    const double farthest = std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])});
    if (farthest > 1e7 || std::abs(n[3]) > 1e6 || std::abs(camera.pitch) > 90 || camera.fov < 1 || camera.fov > 170)
        throw wrong("--view", text, "positions lie within 1e7 m, the pitch in -90..90, the field of view in 1..170");
    return camera;
}

FrameRange rangeFrom(const std::string& text)
{
    const std::size_t dots = text.find("..");
    const std::string_view all = text;
    const auto first = toNumber<int>(all.substr(0, dots));
    const auto last = dots == std::string::npos ? first : toNumber<int>(all.substr(dots + 2));
    if (!first || !last || *first < 0 || *last < *first || *last > 1'000'000)
        throw wrong("--frames", text, "write A..B with 0 <= A <= B, as 0..99");
    return {*first, *last};
}

float timeFrom(const std::string& text)
{
    const auto hours = toNumber<float>(text);
    if (!hours || *hours < 0 || *hours > 24) throw wrong("--time", text, "write hours from 0 to 24, as 17.5");
    return *hours;
}

std::pair<std::string, std::string> settingFrom(const std::string& text)
{
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) throw wrong("--set", text, "write KEY=VALUE");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

renderer::Show showFrom(const std::string& text)
{
    const auto names = enumNames(renderer::Show{});
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end()) throw wrong("--show", text, fmt::format("choose one of {}", fmt::join(names, " ")));
    return renderer::Show(found - names.begin());
}

int countFrom(std::string_view option, const std::string& text, int least)
{
    const auto count = toNumber<int>(text);
    if (!count || *count < least || *count > 1'000'000)
        throw wrong(option, text, fmt::format("write a whole number from {}", least));
    return *count;
}

template <class T>
CLI::Option* option(CLI::App& app, const std::string& name, std::optional<T>& target, T (*convert)(const std::string&),
                    const std::string& help)
{
    return app.add_option_function<std::string>(
        name, [&target, convert](const std::string& text) { target = convert(text); }, help);
}

void addCommon(CLI::App& app, Options& o)
{
    app.add_option("--json", o.json, "write the command's figures as one JSON object (- is stdout)")->type_name("FILE");
    app.add_flag("--quiet", o.quiet, "no progress");
    app.add_option("--config", o.config, "settings of a person, in place of their own")->type_name("FILE");
    app.add_option("--lang", o.language, "language of the window (en, cs)")->type_name("NAME");
    app.add_option_function<std::string>(
           "--log",
           [&o](const std::string& level) {
               o.verbose = true;
               if (!io::log::setLevel(level)) throw wrong("--log", level, "choose debug info warning error off");
           },
           "least level that stderr shows: debug info warning error off")
        ->type_name("LEVEL");
}

void addDrawing(CLI::App& app, Options& o)
{
    app.add_option("--scene", o.scene, "scene of the project (default: its start scene)")->type_name("NAME");
    app.add_option_function<std::string>(
           "--size", [&o](const std::string& text) { o.size = sizeFrom(text), o.sizeGiven = true; },
           "pixels (default 1280x720)")
        ->type_name("WxH");
    app.add_option("--look", o.look, "a look of the day: dawn, noon, golden-hour, dusk, overcast, storm, night or your own")->type_name("NAME");
    option(app, "--time", o.time, timeFrom, "local solar time, 0..24")->type_name("HOURS");
    app.add_option_function<std::vector<std::string>>(
           "--set",
           [&o](const std::vector<std::string>& all) {
               for (const std::string& text : all)
                   o.sets.push_back(settingFrom(text));
           },
           "a value of environment.* or render.*, repeatable")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option_function<std::string>(
           "--quality",
           [&o](const std::string& text) {
               o.quality = qualityNamed(text);
               if (!o.quality) throw wrong("--quality", text, "choose low medium high ultra auto");
           },
           "low medium high ultra auto")
        ->type_name("NAME");
    app.add_flag("--headless", o.headless, "draw without a display");
}

void addView(CLI::App& app, Options& o)
{
    option(app, "--view", o.view, viewFrom, "where the camera is: X,Y,Z,YAW,PITCH[,FOV]")->type_name("VIEW");
    app.add_option("--camera", o.camera, "a camera of the scene")->type_name("NAME");
}

void addProject(CLI::App& app, Options& o, bool required)
{
    app.add_option("PROJECT", o.project, "folder with project.json, or that file")->required(required);
}

void addEdit(CLI::App& app, Options& o)
{
    addProject(app, o, false);
    app.add_option("--replay", o.replay, "feed the events of this file to the editor (docs/replay.md)")
        ->type_name("FILE");
    app.add_option("--shot", o.shots, "after the replay, a picture of the whole window")
        ->type_name("FILE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--ui-map", o.uiMap, "after the replay, every visible widget as JSON")->type_name("FILE");
    app.add_option("--record", o.record, "write what mouse and keys do in the window as events")->type_name("FILE");
    addView(app, o);
}

void addRender(CLI::App& app, Options& o)
{
    addProject(app, o, true);
    app.add_option("--out", o.out, "picture: .png, .jpg, or .exr for linear radiance")->type_name("FILE")->required();
    addView(app, o);
    app.add_option_function<std::string>(
           "--show", [&o](const std::string& text) { o.show = showFrom(text); },
           fmt::format("{}", fmt::join(enumNames(renderer::Show{}), " ")))
        ->type_name("BUFFER");
    option(app, "--cull-from", o.cullFrom, viewFrom, "draw what a camera there would draw, and its view as lines")
        ->type_name("VIEW");
    option(app, "--frames", o.range, rangeFrom, "frames A to B of a camera path, numbered (60 a second)")
        ->type_name("A..B");
    app.add_option_function<std::string>(
           "--count", [&o](const std::string& text) { o.count = countFrom("--count", text, 1); },
           "so many pictures, spread evenly over a camera path")
        ->type_name("N");
    app.add_option("--path", o.path, "camera path of --frames and --count (default: the first)")->type_name("NAME");
}

void addBench(CLI::App& app, Options& o)
{
    addProject(app, o, true);
    app.add_option("--path", o.path, "camera path to fly (default: the first)")->type_name("NAME");
    app.add_option_function<std::string>(
           "--frames", [&o](const std::string& text) { o.frames = countFrom("--frames", text, 1); },
           "frames to measure")
        ->type_name("N");
    app.add_option_function<std::string>(
           "--warmup", [&o](const std::string& text) { o.warmup = countFrom("--warmup", text, 0); },
           "frames drawn before (default 10)")
        ->type_name("N");
    addView(app, o);
}

void addPlay(CLI::App& app, Options& o)
{
    addProject(app, o, true);
    app.add_option("--input", o.input, "what mouse and keys do, an event a line (docs/replay.md)")->type_name("EVENTS.jsonl");
    app.add_option_function<std::string>(
           "--frames", [&o](const std::string& text) { o.frames = countFrom("--frames", text, 1); },
           "steps of 1/60 s (default: as the events last)")
        ->type_name("N");
    app.add_option("--trace", o.trace, "write each step as a JSON line")->type_name("FILE");
    addView(app, o);
}

void addPick(CLI::App& app, Options& o)
{
    addProject(app, o, true);
    app.add_option("--points", o.points, "x y of a pixel on each line")->type_name("FILE")->required();
    addView(app, o);
}

// One App with a subcommand for each command, all writing into `o`.
void build(CLI::App& app, Options& o)
{
    app.set_version_flag("--version", "wold " WOLD_VERSION);
    app.require_subcommand(1);
    const auto command = [&](Command which, const std::string& help, auto&&... adds) {
        CLI::App& sub = *app.add_subcommand(std::string{nameOf(which)}, help);
        sub.option_defaults()->take_last();
        (adds(sub, o), ...);
        addCommon(sub, o);
        sub.callback([&o, which] { o.command = which; });
    };
    command(Command::Edit, "open the editor's window (the default)", addEdit, addDrawing);
    command(Command::Play, "walk through a world as recorded events say", addPlay, addDrawing);
    command(Command::Render, "draw one picture, or a sequence along a path", addRender, addDrawing);
    command(Command::Pick, "what lies under pixels", addPick, addDrawing);
    command(
        Command::Run, "run editor commands, one JSON object a line",
        [](CLI::App& sub, Options& to) {
            addProject(sub, to, true);
            sub.add_option("SCRIPT", to.script, "file of commands, - is stdin")->required();
            addView(sub, to);
        },
        addDrawing);
    command(Command::Bench, "measure drawing along a path", addBench, addDrawing);
    command(Command::Check, "read all that a project names and list every fault", [](CLI::App& sub, Options& to) {
        addProject(sub, to, true);
        sub.add_flag("--fix", to.fix, "mend what can be mended, and save");
    });
    command(Command::New, "make a project from a starter", [](CLI::App& sub, Options& to) {
        sub.add_option("DIR", to.folder, "a folder that is missing or empty")->required();
        sub.add_option("--from", to.starter, "empty or valley")->type_name("NAME");
    });
    command(Command::Info, "versions, the GL device and its limits, paths; counts of a project",
            [](CLI::App& sub, Options& to) {
                addProject(sub, to, false);
                sub.add_option("--scene", to.scene, "scene of the project")->type_name("NAME");
                sub.add_flag("--headless", to.headless, "ask the GL device without a display");
            });
    const auto project = [](CLI::App& sub, Options& to) { addProject(sub, to, true); };
    command(Command::Import, "bring height maps, models, pictures and sounds into a project", project, addImport);
    command(Command::Export, "write a world, or its ground, for other programs", project, addExport);
}

// The first word that is neither an option nor an option's value.
std::size_t firstWord(const CLI::App& app, const std::vector<std::string>& arguments)
{
    std::size_t i = 0;
    for (; i < arguments.size(); ++i) {
        const std::string& word = arguments[i];
        if (word.size() < 2 || word[0] != '-') break;
        for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
            if (const CLI::Option* known = sub->get_option_no_throw(word)) {
                i += known->get_expected_max() > 0 ? 1 : 0;
                break;
            }
    }
    return std::min(i, arguments.size());
}

// `wold PROJECT` means edit, and options may stand before the command.
void putCommandFirst(const CLI::App& app, std::vector<std::string>& arguments)
{
    if (arguments.size() == 1 && (arguments[0] == "--help" || arguments[0] == "-h" || arguments[0] == "--version"))
        return;
    const std::size_t at = firstWord(app, arguments);
    const bool named = at < arguments.size() && (std::ranges::count(kCommands, arguments[at]) > 0 ||
                                                 std::ranges::count(kLater, arguments[at]) > 0);
    if (named)
        std::rotate(arguments.begin(), arguments.begin() + std::ptrdiff_t(at),
                    arguments.begin() + std::ptrdiff_t(at) + 1);
    else
        arguments.insert(arguments.begin(), "edit");
}

std::optional<std::string> contradiction(const Options& o)
{
    const bool sequence = o.range || o.count > 0;
    if (o.command == Command::Render && !o.path.empty() && !sequence) return "--path needs --frames A..B or --count N";
    if (int(o.view.has_value()) + int(!o.camera.empty()) + int(o.range.has_value()) + int(o.count > 0) > 1)
        return "--view, --camera, --frames and --count exclude each other";
    if (o.replay.empty() && (!o.shots.empty() || !o.uiMap.empty())) return "--shot and --ui-map go with --replay";
    if (!o.replay.empty() && !o.record.empty()) return "--record and --replay exclude each other";
    if (!o.replay.empty() && o.project.empty()) return "--replay needs a PROJECT";
    return std::nullopt;
}

Ending misuse(const CLI::App& app, std::string_view what)
{
    return {2, fmt::format("{}\nwold: {}\n", app.help(), what)}; // of the command, where one is named
}

} // namespace

std::variant<Options, Ending> parseOptions(std::vector<std::string> arguments)
{
    Options options;
    CLI::App app{"Wold, an editor for open worlds. `wold PROJECT` opens the editor.", "wold"};
    build(app, options);
    putCommandFirst(app, arguments);
    if (std::ranges::count(kLater, arguments.front()) > 0)
        return misuse(app, fmt::format("{}: comes with a later release", arguments.front()));
    std::reverse(arguments.begin(), arguments.end()); // as CLI11 takes them
    try {
        app.parse(arguments);
    } catch (const CLI::CallForHelp&) {
        return Ending{0, app.help()};
    } catch (const CLI::CallForVersion& version) {
        return Ending{0, fmt::format("{}\n", version.what())};
    } catch (const CLI::Error& error) {
        return misuse(app, error.what());
    }
    if (const auto fault = contradiction(options)) return misuse(app, *fault);
    return options;
}

std::string_view nameOf(Command command)
{
    return kCommands[std::size_t(command)];
}

std::optional<Quality> qualityNamed(std::string_view name)
{
    const auto found = std::ranges::find(kQualities, name);
    if (found == kQualities.end()) return std::nullopt;
    return Quality(found - kQualities.begin());
}

std::string_view nameOf(Quality quality)
{
    return kQualities[std::size_t(quality)];
}

} // namespace app
