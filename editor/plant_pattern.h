// PlantPattern: where plants of a mix could stand on an endless plain, from a seed alone. Every place of the plane answers by
// itself: whoever asks for a part, in whatever order, gets the same points, and none stands too near to one beyond the edge.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace editor {

struct PatternKind {
    float weight = 1;  // share of it in the mix
    float spacing = 0; // m, the least between two of this kind
    float room = 0;    // m, radius: no two plants stand nearer than their rooms together
    bool operator==(const PatternKind&) const = default;
};

struct PatternRules {
    std::vector<PatternKind> kinds;
    double density = 0.1; // points per m2
    double spacing = 0;   // m, the least between any two
    std::uint64_t seed = 1;

    double least(std::size_t a, std::size_t b) const; // m between one of each
    double widest() const;                            // m, the largest of those
};

struct PatternPoint {
    glm::dvec2 at{0};         // world x and z, on a grid of 1/1024 m
    std::uint32_t kind = 0;   // of the rules'
    glm::ivec2 square{0};     // that it belongs to, and its number there
    std::uint32_t index = 0;
    std::uint64_t seed = 0;   // for what else is drawn of it
};

// A part of the plane, the high edges excluded.
struct PlaneRect {
    glm::dvec2 low{0}, high{0};
    bool contains(const glm::dvec2& at) const { return at.x >= low.x && at.y >= low.y && at.x < high.x && at.y < high.y; }
};

class PlantPattern {
public:
    explicit PlantPattern(PatternRules rules);

    std::vector<PatternPoint> points(const PlaneRect& part) const;

    // The plane is cut into squares; each has as many points as the density asks for, while they find room.
    glm::ivec2 squareAt(const glm::dvec2& at) const;
    PlaneRect wholeSquares(const PlaneRect& part) const; // that it touches
    int wanted(const glm::ivec2& square) const;
    double side() const { return m_side; } // m
    std::uint32_t kindFor(double share) const; // 0..1, of the weights
    const PatternRules& rules() const { return m_rules; }

private:
    struct Grid;
    std::uint64_t seedOf(const glm::ivec2& square) const;
    void fill(Grid& grid, const glm::ivec2& square) const;
    bool hasRoom(const Grid& grid, const glm::ivec2& square, const PatternPoint& point) const;

    PatternRules m_rules;
    std::vector<double> m_upTo; // of each kind, the weights up to it
    std::vector<double> m_least; // squared, of each pair
    double m_side = 1;
    int m_most = 1; // points in a square
};

} // namespace editor
