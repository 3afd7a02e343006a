#include "app/opened.h"

#include "app/drawing_settings.h"
#include "app/report.h"
#include "editor/properties.h"
#include "io/files/kept_looks.h"

#include <chrono>
#include <fmt/format.h>

namespace app {
namespace {

constexpr std::string_view kRender = "render.", kEnvironment = "environment.";

std::string projectFile(const editor::Document& document)
{
    return (document.project().folder / "project.json").string();
}

template <class Named> std::string namesOf(std::span<const Named> all)
{
    std::string names;
    for (const Named& one : all)
        names += (names.empty() ? "" : ", ") + one.name;
    return names.empty() ? "none" : names;
}

// Ten metres above the ground in the middle of what there is.
io::Camera middleOf(const editor::Document& document)
{
    io::Camera camera{.name = "middle"};
    if (const auto& heights = document.scene().heights()) {
        const glm::dvec2 middle = heights->origin + glm::dvec2{heights->size - 1} * heights->metresPerTexel * 0.5;
        camera.eye = {middle.x, heights->height(middle.x, middle.y).value_or(0) + 10, middle.y};
        return camera;
    }
    io::WorldBox box;
    for (const io::Object& object : document.scene().objects())
        box.add(io::worldBounds(document.assets(), object));
    if (!box.empty()) camera.eye = box.centre() + glm::dvec3{0, 0, glm::length(box.size())};
    return camera;
}

} // namespace

int applyToWorld(const Options& options, editor::Document& document)
{
    if (!options.look.empty()) {
        io::Complaints complaints;
        io::Result<io::Environment> look =
            io::lookNamed(options.look, document.scene().environment(), io::KeptLooks{io::looksFolder()}, complaints);
        if (!look) return misuse("--look " + look.error().text());
        logComplaints(complaints);
        editor::setEnvironment(document, "Look of the day", *std::move(look));
    }
    if (options.time) {
        const io::Status set = editor::setProperty(document, "environment.time", double(*options.time));
        if (!set) return misuse(set.error().text());
    }
    std::vector<editor::Property> properties;
    for (const auto& [key, value] : options.sets) {
        if (key.starts_with(kRender)) continue;
        if (!key.starts_with(kEnvironment))
            return misuse(fmt::format("--set {}: keys begin with environment. or render.", key));
        properties.push_back({key, editor::valueFromText(value)});
    }
    const io::Status set = editor::setProperties(document, properties);
    return set ? 0 : misuse("--set " + set.error().text());
}

int applyToDrawing(const Options& options, renderer::Settings& drawing)
{
    for (const auto& [key, value] : options.sets) {
        if (!key.starts_with(kRender)) continue;
        const std::string name = key.substr(kRender.size());
        const io::Status set = setDrawing(drawing, name, editor::valueFromText(value));
        if (!set) return misuse("--set " + set.error().text());
    }
    return 0;
}

std::variant<Opened, int> openAsAsked(const Options& options)
{
    Opened opened;
    // The cheap mistakes first: a wrong --set should not wait for a world to be read.
    if (const int code = applyToDrawing(options, opened.drawing)) return code;
    const auto start = std::chrono::steady_clock::now();
    auto document = editor::Document::open(options.project, options.scene, progressOnStderr(options.quiet));
    if (!document) return fault(document.error());
    opened.document = *std::move(document);
    opened.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    logComplaints(opened.document->complaints());
    if (const int code = applyToWorld(options, *opened.document)) return code;
    return opened;
}

io::Result<io::Camera> cameraFor(const Options& options, const editor::Document& document)
{
    if (options.view) return *options.view;
    const auto cameras = document.scene().cameras();
    if (!options.camera.empty()) {
        if (const io::Camera* found = document.scene().findCamera(options.camera)) return *found;
        return io::Error{projectFile(document),
                         fmt::format("has no camera \"{}\"; its cameras: {}", options.camera, namesOf(cameras))};
    }
    return cameras.empty() ? middleOf(document) : cameras.front();
}

io::Result<io::CameraPath> pathFor(const Options& options, const editor::Document& document)
{
    const auto paths = document.scene().paths();
    if (const io::CameraPath* found = document.scene().findPath(options.path)) return *found;
    if (options.path.empty() && !paths.empty()) return paths.front();
    return io::Error{projectFile(document),
                     options.path.empty()
                         ? "has no camera path; add one to \"paths\""
                         : fmt::format("has no camera path \"{}\"; its paths: {}", options.path, namesOf(paths))};
}

} // namespace app
