// wold info: versions, the device that draws and its limits, paths; of a project its counts and sizes.
#include "app/commands/commands.h"
#include "app/gl_context.h"
#include "app/report.h"
#include "app/settings.h"
#include "editor/instance_edits.h"
#include "editor/document.h"
#include "io/base/paths.h"
#include "renderer/device.h"

#include <cstdio>
#include <fmt/format.h>
#include <set>

namespace app {
namespace {

io::Value deviceFacts(bool headless)
{
    const auto context = makePictureContext(headless);
    if (!context) return io::Value::Object{{"error", context.error().text()}};
    const renderer::Device device = renderer::describeDevice();
    io::Value::Object limits;
    for (const auto& [name, value] : device.limits)
        limits.emplace_back(name, value);
    io::Value::Array extensions{device.extensions.begin(), device.extensions.end()};
    return io::Value::Object{{"renderer", device.name},
                             {"vendor", device.vendor},
                             {"version", device.version},
                             {"shading_language", device.shadingLanguage},
                             {"platform", (*context)->platform()},
                             {"limits", std::move(limits)},
                             {"extensions", std::move(extensions)}};
}

io::Value pathFacts()
{
    return io::Value::Object{{"resources", io::resource("app").parent_path().string()},
                             {"settings", Settings::defaultFile().string()},
                             {"state", io::stateFolder().string()},
                             {"cache", io::cacheFolder().string()}};
}

io::Value terrainFacts(const io::Scene& scene)
{
    if (!scene.heights()) return {};
    const io::HeightMap& heights = *scene.heights();
    const glm::dvec2 metres = glm::dvec2{heights.size - 1} * heights.metresPerTexel;
    return io::Value::Object{{"size", io::Value::Array{heights.size.x, heights.size.y}},
                             {"metres", io::Value::Array{metres.x, metres.y}},
                             {"lowest", heights.min},
                             {"highest", heights.max}};
}

void addPathsAndCameras(const io::Scene& scene, io::Value& facts)
{
    io::Value::Array cameras;
    for (const io::Camera& camera : scene.cameras())
        cameras.emplace_back(camera.name);
    io::Value::Object paths;
    for (const io::CameraPath& path : scene.paths())
        paths.emplace_back(path.name, io::duration(path));
    facts["cameras"] = std::move(cameras);
    facts["paths_seconds"] = std::move(paths);
}

io::Value projectFacts(const editor::Document& document)
{
    const io::Scene& scene = document.scene();
    std::uint64_t instances = 0, triangles = 0, templates = 0;
    std::set<std::string> models;
    for (const io::Object& object : scene.objects()) {
        const io::Model* model = document.assets().model(object.templateId);
        if (!model) continue; // a group
        ++instances;
        const io::Template* of = scene.find(object.templateId);
        if (of && !of->model.empty()) triangles += model->triangles(); // markers are not of the world
    }
    instances += scene.instanceCount();
    for (const io::ScatterLayer& layer : scene.scatterLayers())
        triangles += editor::trianglesOf(document, layer);
    for (const auto& slot : scene.templates()) {
        templates += slot.value.has_value();
        if (slot.value && !slot.value->model.empty()) models.insert(slot.value->model);
    }
    io::Value facts = io::Value::Object{{"name", document.project().name},
                                        {"scene", document.world().entry.name},
                                        {"objects", std::uint64_t(scene.objects().size())},
                                        {"instances", instances},
                                        {"triangles", triangles},
                                        {"templates", templates},
                                        {"models", std::uint64_t(models.size())},
                                        {"terrain", terrainFacts(document.scene())}};
    addPathsAndCameras(scene, facts);
    return facts;
}

void print(const io::Value& value, std::string_view name, int depth)
{
    const std::string head(std::size_t(depth) * 2, ' ');
    if (const auto* members = value.asObject()) {
        if (!name.empty()) fmt::print("{}{}:\n", head, name);
        for (const auto& [key, member] : *members)
            print(member, key, depth + (name.empty() ? 0 : 1));
    } else if (const auto* items = value.asArray()) {
        std::string list;
        for (const io::Value& item : *items)
            list +=
                (list.empty() ? "" : ", ") + (item.asString() ? *item.asString() : fmt::format("{}", *item.asNumber()));
        fmt::print("{}{}: {}\n", head, name, list);
    } else if (const auto* text = value.asString()) {
        fmt::print("{}{}: {}\n", head, name, *text);
    } else if (const auto* number = value.asNumber()) {
        fmt::print("{}{}: {}\n", head, name, *number);
    }
}

} // namespace

int info(const Options& options)
{
    io::Value facts = io::Value::Object{{"wold", WOLD_VERSION}, {"compiler", "g++ " __VERSION__}};
    facts["gl"] = deviceFacts(options.headless);
    facts["paths"] = pathFacts();
    if (!options.project.empty()) {
        const auto document = editor::Document::open(options.project, options.scene, progressOnStderr(options.quiet));
        if (!document) return fault(document.error());
        logComplaints((*document)->complaints());
        const io::Value project = projectFacts(**document);
        for (const auto& [key, value] : *project.asObject())
            facts[key] = value;
    }
    if (options.json != "-") print(facts, "", 0);
    const io::Status written = writeFigures(options.json, facts);
    return written ? 0 : fault(written.error());
}

} // namespace app
