#include "editor/script_commands.h"

#include "editor/properties.h"
#include "io/scene/field_words.h"

#include <algorithm>

namespace editor {
namespace {

std::optional<SelectMode> modeNamed(std::string_view name)
{
    if (name == "set") return SelectMode::Set;
    if (name == "add") return SelectMode::Add;
    if (name == "remove") return SelectMode::Remove;
    if (name == "toggle") return SelectMode::Toggle;
    return std::nullopt;
}

PixelRect rectOf(Arguments& arguments)
{
    const io::Value* box = arguments.value("box");
    const io::Value::Array* corners = box->asArray();
    double n[4] = {};
    for (int i = 0; i < 4; ++i) {
        const double* number = corners && corners->size() == 4 ? (*corners)[std::size_t(i)].asNumber() : nullptr;
        if (!number) arguments.fail("\"box\" must be [x0, y0, x1, y1]");
        n[i] = number ? *number : 0;
    }
    return {{n[0], n[1]}, {n[2], n[3]}};
}

std::vector<io::ObjectId> chosen(Script& script, Arguments& arguments)
{
    const io::Scene& scene = script.document().scene();
    const Hierarchy& hierarchy = script.document().hierarchy();
    const bool whole = arguments.flag("whole_groups", true);
    const auto grouped = [&](std::vector<io::ObjectId> ids) { return whole ? wholeGroups(hierarchy, ids) : ids; };
    int ways = 0;
    for (const char* way : {"ids", "pixel", "box", "template", "all"})
        ways += arguments.has(way);
    if (ways != 1) {
        arguments.fail("needs one of \"ids\", \"pixel\", \"box\", \"template\" and \"all\"");
        return {};
    }
    if (arguments.has("ids")) {
        const io::Value::Array* given = arguments.value("ids")->asArray();
        return given && given->empty() ? std::vector<io::ObjectId>{} : arguments.ids();
    }
    if (arguments.has("box")) return grouped(script.picker().pickBox(script.view(), rectOf(arguments)));
    if (arguments.has("template")) {
        const io::TemplateId what = arguments.templateNamed("template");
        std::vector<io::ObjectId> ids;
        for (const io::Object& object : scene.objects())
            if (object.templateId == what) ids.push_back(object.id);
        std::ranges::sort(ids);
        return ids;
    }
    if (arguments.has("all"))
        return arguments.flag("all", true) ? allObjects(scene, hierarchy) : std::vector<io::ObjectId>{};
    const PickHit hit = script.picker().pick(script.view(), *arguments.pair("pixel"));
    return hit.id != io::ObjectId::None ? grouped({hit.id}) : std::vector<io::ObjectId>{};
}

Answer select(Script& script, Arguments& arguments)
{
    const std::vector<io::ObjectId> ids = chosen(script, arguments);
    const auto mode = modeNamed(arguments.text("mode", "set"));
    if (!mode) arguments.fail("\"mode\" is set, add, remove or toggle");
    if (const auto fault = arguments.finish()) return *fault;
    script.selection().apply(*mode, ids);
    return io::Value::Object{{"count", std::uint64_t(script.selection().size())}};
}

bool isSetting(std::string_view key)
{
    return key.starts_with("render.");
}

Answer set(Script& script, Arguments& arguments)
{
    const std::string key = arguments.text("key");
    const io::Value* value = arguments.value("value");
    if (!value) arguments.fail("needs \"value\"");
    if (isSetting(key) && !script.hooks().setSetting) arguments.fail("settings of drawing are not available here");
    if (const auto fault = arguments.finish()) return *fault;
    const io::Status done =
        isSetting(key) ? script.hooks().setSetting(key, *value) : setProperty(script.document(), key, *value);
    if (!done) return done.error();
    return io::Value::Object{{"key", key}};
}

Answer get(Script& script, Arguments& arguments)
{
    const std::string key = arguments.text("key");
    if (isSetting(key) && !script.hooks().getSetting) arguments.fail("settings of drawing are not available here");
    if (const auto fault = arguments.finish()) return *fault;
    io::Result<io::Value> value = isSetting(key) ? script.hooks().getSetting(key) : getProperty(script.document(), key);
    if (!value) return value.error();
    return io::Value::Object{{"value", std::move(*value)}};
}

Answer undo(Script& script, Arguments& arguments)
{
    if (const auto fault = arguments.finish()) return *fault;
    if (!script.document().history().canUndo()) return io::Error{{}, "there is nothing to undo"};
    return io::Value::Object{{"undone", script.document().undo()}};
}

Answer redo(Script& script, Arguments& arguments)
{
    if (const auto fault = arguments.finish()) return *fault;
    if (!script.document().history().canRedo()) return io::Error{{}, "there is nothing to redo"};
    return io::Value::Object{{"redone", script.document().redo()}};
}

Answer saved(const io::Result<io::FileTransaction::Report>& report, const std::filesystem::path& folder)
{
    if (!report) return report.error();
    io::Value::Array files;
    for (const std::filesystem::path& file : report->written)
        files.emplace_back((file.is_absolute() ? file.lexically_relative(folder) : file).generic_string());
    return io::Value::Object{{"bytes", report->bytes}, {"files", std::move(files)}};
}

Answer save(Script& script, Arguments& arguments)
{
    if (const auto fault = arguments.finish()) return *fault;
    return saved(script.document().save(), script.document().project().folder);
}

Answer saveAs(Script& script, Arguments& arguments)
{
    const std::string folder = arguments.text(arguments.has("folder") ? "folder" : "path");
    if (folder.empty()) arguments.fail("\"path\" names a new folder");
    if (const auto fault = arguments.finish()) return *fault;
    const auto report = script.document().saveAs(folder);
    return saved(report, script.document().project().folder);
}

Answer reload(Script& script, Arguments& arguments)
{
    if (const auto fault = arguments.finish()) return *fault;
    if (const io::Status done = script.document().reload(); !done) return done.error();
    return io::Value::Object{{"objects", std::uint64_t(script.document().scene().objects().size())}};
}

Answer view(Script& script, Arguments& arguments)
{
    View changed = script.view();
    const std::string name = arguments.text("camera", "");
    if (!name.empty()) {
        const io::Camera* camera = script.document().scene().findCamera(name);
        if (!camera) arguments.fail("there is no camera \"" + name + "\"");
        if (camera) changed.camera = *camera;
    }
    io::Camera& camera = changed.camera;
    camera.eye = arguments.triple("eye").value_or(camera.eye);
    camera.yaw = float(arguments.number("yaw", camera.yaw, -1e6, 1e6));
    camera.pitch = float(arguments.number("pitch", camera.pitch, -90, 90));
    camera.fov = float(arguments.number("fov", camera.fov, 1, 170));
    if (const auto size = arguments.pair("size")) {
        if (!(size->x >= 1 && size->y >= 1 && size->x <= 16384 && size->y <= 16384))
            arguments.fail("\"size\" is 1 to 16384 pixels a side");
        changed.size = glm::ivec2{*size};
    }
    if (const auto fault = arguments.finish()) return *fault;
    script.view() = changed;
    return io::Value::Object{{"eye", toValue(camera.eye)},
                             {"yaw", io::decimal(camera.yaw)},
                             {"pitch", io::decimal(camera.pitch)},
                             {"fov", io::decimal(camera.fov)}};
}

Answer render(Script& script, Arguments& arguments)
{
    RenderRequest request{.out = arguments.text("out"), .view = script.view(), .show = arguments.text("show", "final")};
    if (const auto size = arguments.pair("size")) {
        if (!(size->x >= 1 && size->y >= 1 && size->x <= 16384 && size->y <= 16384))
            arguments.fail("\"size\" is 1 to 16384 pixels a side");
        request.view.size = glm::ivec2{*size};
    }
    if (!script.hooks().render) arguments.fail("pictures are not available here");
    if (const auto fault = arguments.finish()) return *fault;
    if (const io::Status done = script.hooks().render(request); !done) return done.error();
    return io::Value::Object{{"out", request.out.generic_string()}};
}

constexpr ScriptCommand kCommands[] = {
    {"select", select}, {"set", set},   {"get", get},        {"undo", undo},     {"redo", redo},
    {"save", save},     {"view", view}, {"save_as", saveAs}, {"reload", reload}, {"render", render},
};

} // namespace

std::span<const ScriptCommand> documentCommands()
{
    return kCommands;
}

} // namespace editor
