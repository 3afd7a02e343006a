#include "app/play/shape_lines.h"

#include <algorithm>
#include <cmath>

namespace play {
namespace {

constexpr std::size_t kMostLines = 40'000;
constexpr int kSides = 16;         // of a circle
constexpr double kOnPlane = 1e-4;  // share of the size

} // namespace

// Corners of which two sides meet both.
const ShapeLines::Edges& ShapeLines::edgesOf(Session& session, io::TemplateId id)
{
    const auto [at, fresh] = m_edges.try_emplace(id);
    if (!fresh) return at->second;
    const auto bulk = bulkOf(session.surroundings().shapes(), id, {1, 1, 1});
    if (!bulk || bulk->rim > 0) return at->second;
    double size = 0;
    for (const glm::dvec3& corner : bulk->corners)
        size = std::max(size, glm::length(corner));
    for (std::size_t i = 0; i < bulk->corners.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const auto on = [&](const Plane& plane) {
                const auto near = [&](const glm::dvec3& corner) { return std::abs(glm::dot(corner, plane.normal) - plane.distance) < kOnPlane * size; };
                return near(bulk->corners[i]) && near(bulk->corners[k]);
            };
            if (std::ranges::count_if(bulk->planes, on) >= 2) at->second.emplace_back(bulk->corners[i] + bulk->centre, bulk->corners[k] + bulk->centre);
        }
    return at->second;
}

void ShapeLines::addCapsule(const glm::dvec3& middle, const glm::dmat3& turn, int axis, double radius, double stem, LineOf of)
{
    const glm::dvec3 along = turn[axis], u = turn[(axis + 1) % 3] * radius, v = turn[(axis + 2) % 3] * radius;
    const auto round = [&](const glm::dvec3& a, const glm::dvec3& b, int part, int parts) {
        const double angle = glm::radians(360.0) * part / parts;
        return a * std::cos(angle) + b * std::sin(angle);
    };
    for (const double end : {-stem, stem})
        for (int i = 0; i < kSides; ++i) {
            const glm::dvec3 at = middle + along * end, cap = along * (end < 0 ? -radius : radius);
            m_lines.push_back({at + round(u, v, i, kSides), at + round(u, v, i + 1, kSides), of});
            if (i >= kSides / 2) continue;
            m_lines.push_back({at + round(u, cap, i, kSides), at + round(u, cap, i + 1, kSides), of});
            m_lines.push_back({at + round(v, cap, i, kSides), at + round(v, cap, i + 1, kSides), of});
        }
    for (const glm::dvec3& side : {u, v, -u, -v})
        m_lines.push_back({middle + side - along * stem, middle + side + along * stem, of});
}

const std::vector<ShapeLine>& ShapeLines::around(Session& session)
{
    m_lines.clear();
    Surroundings& surroundings = session.surroundings();
    const glm::dvec3 middle = session.walker().centre();
    const io::WorldBox box{middle - kReach, middle + kReach};
    for (const Thing& thing : surroundings.find(box))
        if (thing.kind == Thing::Kind::Triangle && m_lines.size() < kMostLines)
            for (std::size_t i = 0; i < 3; ++i)
                m_lines.push_back({thing.corners[i], thing.corners[(i + 1) % 3], LineOf::Standing});
    std::vector<Standing> things;
    surroundings.standing(box, things);
    for (const Standing& thing : things) {
        const Shape& shape = surroundings.shapes().of(thing.templateId);
        if (shape.form == Form::None || shape.form == Form::Mesh || m_lines.size() > kMostLines) continue;
        const LineOf of = session.bodies().holds(thing.id) ? LineOf::Moving : LineOf::Standing;
        const glm::dmat4 world = io::worldFromModel(thing.transform);
        if (shape.form == Form::Capsule) {
            const auto bulk = bulkOf(surroundings.shapes(), thing.templateId, thing.transform.scale);
            const glm::dquat turn = io::orientation(thing.transform.rotation);
            addCapsule(thing.transform.position + turn * bulk->centre, glm::mat3_cast(turn), shape.axis, bulk->rim, glm::length(bulk->corners[0]), of);
        } else {
            for (const auto& [from, to] : edgesOf(session, thing.templateId))
                m_lines.push_back({glm::dvec3{world * glm::dvec4{from, 1}}, glm::dvec3{world * glm::dvec4{to, 1}}, of});
        }
    }
    const Mover mover = session.walker().mover();
    if (!mover.isBox()) {
        // Turned with the eye, so that no line of it is right before that.
        addCapsule(middle, glm::mat3_cast(io::orientation({0, float(session.walker().yaw()) + 45, 0})), 1, mover.radius, mover.stem, LineOf::Player);
    } else {
        for (int axis = 0; axis < 3; ++axis)
            for (const glm::dvec2& side : {glm::dvec2{-1, -1}, {-1, 1}, {1, -1}, {1, 1}}) {
                glm::dvec3 from{0};
                from[axis] = -1;
                from[(axis + 1) % 3] = side.x;
                from[(axis + 2) % 3] = side.y;
                glm::dvec3 to = from;
                to[axis] = 1;
                m_lines.push_back({middle + from * mover.half, middle + to * mover.half, LineOf::Player});
            }
    }
    return m_lines;
}

} // namespace play
