// What things are to those that run into them, as lines to be drawn over the picture.
#pragma once

#include "app/play/session.h"

#include <map>
#include <utility>
#include <vector>

namespace play {

enum class LineOf { Standing, Moving, Player };

struct ShapeLine {
    glm::dvec3 from{0}, to{0}; // m
    LineOf of = LineOf::Standing;
};

class ShapeLines {
public:
    static constexpr double kReach = 12; // m around the player
    // Of the session as it is now; of the last one that was given.
    const std::vector<ShapeLine>& around(Session& session);

private:
    using Edges = std::vector<std::pair<glm::dvec3, glm::dvec3>>; // model space
    const Edges& edgesOf(Session& session, io::TemplateId id);
    void addCapsule(const glm::dvec3& middle, const glm::dmat3& turn, int axis, double radius, double stem, LineOf of);

    std::vector<ShapeLine> m_lines;
    std::map<io::TemplateId, Edges> m_edges;
};

} // namespace play
