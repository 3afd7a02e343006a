#include "editor/path_tool.h"

#include "editor/camera_paths.h"
#include "editor/document.h"
#include "editor/text.h"

#include <algorithm>

namespace editor {
namespace {

constexpr double kReach = 9;       // pixels from a key's middle
constexpr int kPiecesOfLeg = 24;
constexpr double kLooks = 1.5;     // m, of the line that shows which way a key looks
constexpr glm::vec4 kWay{0.35f, 0.8f, 1, 0.9f}, kLook{1, 0.85f, 0.4f, 0.8f};

// Where the ray through a pixel meets the plane through `place` that faces the eye.
std::optional<glm::dvec3> onPlane(const View& view, glm::dvec2 pixel, const glm::dvec3& place)
{
    const io::Ray ray = rayThrough(view, pixel);
    const glm::dvec3 normal = io::forward(view.camera);
    const double along = glm::dot(ray.direction, normal), away = glm::dot(place - ray.origin, normal);
    if (along <= 1e-6 || away <= 0) return {};
    return ray.origin + ray.direction * (away / along);
}

io::Camera cameraAt(const io::PathKey& key)
{
    return {.eye = key.eye, .yaw = key.yaw, .pitch = key.pitch, .fov = key.fov};
}

} // namespace

const io::CameraPath* PathTool::target(const Document& document) const
{
    return path.empty() ? nullptr : document.scene().findPath(path);
}

std::vector<std::optional<glm::dvec2>> PathTool::keysOnScreen(const Document& document, const View& view) const
{
    std::vector<std::optional<glm::dvec2>> keys;
    if (const io::CameraPath* shown = target(document); shown && !flying())
        for (const io::PathKey& key : shown->keys)
            keys.push_back(project(view, key.eye));
    return keys;
}

std::optional<std::size_t> PathTool::keyUnder(const Document& document, const View& view, glm::dvec2 pixel) const
{
    const auto keys = keysOnScreen(document, view);
    std::optional<std::size_t> nearest;
    double least = kReach;
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (keys[i] && glm::distance(*keys[i], pixel) <= least) {
            least = glm::distance(*keys[i], pixel);
            nearest = i;
        }
    return nearest;
}

bool PathTool::begin(Document& document, const View& view, glm::dvec2 pixel)
{
    m_dragged = keyUnder(document, view, pixel);
    if (!m_dragged) return false;
    const glm::dvec3 place = target(document)->keys[*m_dragged].eye;
    m_grabbed = place - onPlane(view, pixel, place).value_or(place);
    document.beginGesture(tr("undo.move_key"));
    return true;
}

void PathTool::drag(Document& document, const View& view, glm::dvec2 pixel)
{
    const io::CameraPath* shown = target(document);
    if (!m_dragged || !shown || *m_dragged >= shown->keys.size() || !document.inGesture()) return;
    const auto at = onPlane(view, pixel, shown->keys[*m_dragged].eye);
    if (!at || *at + m_grabbed == shown->keys[*m_dragged].eye) return;
    std::vector<io::CameraPath> paths = pathsOf(document.scene());
    std::ranges::find(paths, path, &io::CameraPath::name)->keys[*m_dragged].eye = *at + m_grabbed;
    setPaths(document, tr("undo.move_key"), std::move(paths));
}

void PathTool::end(Document& document, bool keep)
{
    if (!std::exchange(m_dragged, std::nullopt) || !document.inGesture()) return;
    if (keep) document.endGesture();
    else document.cancelGesture();
}

void PathTool::fly(FlyCamera& camera)
{
    if (!m_before) m_before = camera.camera();
    m_goes = true;
}

void PathTool::show(const Document& document, FlyCamera& camera, double seconds)
{
    const io::CameraPath* shown = target(document);
    if (!shown || shown->keys.empty()) return;
    if (!m_before) m_before = camera.camera();
    m_goes = false;
    time = std::clamp(seconds, 0.0, io::duration(*shown));
    camera.setCamera(io::sample(*shown, time));
}

void PathTool::stop(FlyCamera& camera)
{
    if (m_before) camera.setCamera(*std::exchange(m_before, std::nullopt));
}

void PathTool::update(const Document& document, FlyCamera& camera, double seconds)
{
    if (!flying()) return;
    const io::CameraPath* shown = target(document);
    if (!shown || (m_goes && time >= io::duration(*shown))) {
        time = 0;
        return stop(camera);
    }
    if (!m_goes) return;
    camera.setCamera(io::sample(*shown, time));
    time += seconds;
}

void PathTool::addLines(const Document& document, std::vector<renderer::Line>& lines) const
{
    const io::CameraPath* shown = target(document);
    if (!shown || flying() || shown->keys.empty()) return;
    const double begin = shown->keys.front().time;
    for (std::size_t leg = 0; leg + 1 < shown->keys.size(); ++leg) {
        const double from = shown->keys[leg].time - begin, span = shown->keys[leg + 1].time - shown->keys[leg].time;
        glm::dvec3 last = shown->keys[leg].eye;
        for (int i = 1; i <= kPiecesOfLeg; ++i) {
            const glm::dvec3 next = io::sample(*shown, from + span * i / kPiecesOfLeg).eye;
            lines.push_back({.from = last, .to = next, .colour = kWay, .onTop = true});
            last = next;
        }
    }
    for (const io::PathKey& key : shown->keys) {
        const io::Camera looks = shown->lookAt ? io::lookingAt(cameraAt(key), shown->target) : cameraAt(key);
        lines.push_back({.from = key.eye, .to = key.eye + io::forward(looks) * kLooks, .colour = kLook, .onTop = true});
    }
}

} // namespace editor
