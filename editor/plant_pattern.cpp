#include "editor/plant_pattern.h"

#include "editor/random.h"
#include "io/scene/instances.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

constexpr int kTries = 30;         // places that are looked at for one point
constexpr double kAimed = 8;       // points in a square
constexpr double kDensest = 0.75;  // points that find room, by the square of their spacing: discs thrown at random jam at 0.70
constexpr int kMostInASquare = 4096;

} // namespace

double PatternRules::least(std::size_t a, std::size_t b) const
{
    return std::max({spacing, a == b ? double(kinds[a].spacing) : 0.0, double(kinds[a].room) + double(kinds[b].room)});
}

double PatternRules::widest() const
{
    double widest = spacing;
    float room = 0;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        widest = std::max(widest, least(i, i));
        room = std::max(room, kinds[i].room);
    }
    return std::max(widest, 2.0 * double(room));
}

// Squares take turns by the parity of their place, four in all: one reads only neighbours that had theirs before. So a square
// depends on what lies at most three squares away, and those of one turn not on each other.
struct PlantPattern::Grid {
    glm::ivec2 from, size;
    int most;
    std::vector<int> counts;
    std::vector<PatternPoint> points; // `most` for each square

    std::size_t indexOf(const glm::ivec2& square) const { return std::size_t(square.y - from.y) * size.x + (square.x - from.x); }
};

PlantPattern::PlantPattern(PatternRules rules) : m_rules{std::move(rules)}
{
    double sum = 0;
    for (const PatternKind& kind : m_rules.kinds)
        m_upTo.push_back(sum += std::max(0.0, double(kind.weight)));
    for (std::size_t a = 0; a < m_rules.kinds.size(); ++a)
        for (std::size_t b = 0; b < m_rules.kinds.size(); ++b)
            m_least.push_back(m_rules.least(a, b) * m_rules.least(a, b));
    if (sum <= 0) m_rules.density = 0;
    // A little wider than the spacing, as places are rounded to the grid.
    m_side = std::max({m_rules.widest() + 4 * io::kInstanceStep, m_rules.density > 0 ? std::sqrt(kAimed / m_rules.density) : 1.0, 0.05});
    m_side = std::min(m_side, 1e5);
    const double fits = m_rules.spacing > 0 ? kDensest * m_side * m_side / (m_rules.spacing * m_rules.spacing) + 3 : kMostInASquare;
    m_most = std::clamp(int(std::min(std::ceil(m_rules.density * m_side * m_side), fits)), 1, kMostInASquare);
}

glm::ivec2 PlantPattern::squareAt(const glm::dvec2& at) const
{
    return glm::ivec2{glm::floor(at / m_side)};
}

PlaneRect PlantPattern::wholeSquares(const PlaneRect& part) const
{
    const double step = io::kInstanceStep; // that places are rounded by
    return {glm::dvec2{squareAt(part.low)} * m_side - step, glm::dvec2{squareAt(part.high + step) + 1} * m_side};
}

std::uint64_t PlantPattern::seedOf(const glm::ivec2& square) const
{
    const std::uint64_t place = std::uint64_t(std::uint32_t(square.x)) << 32 | std::uint32_t(square.y);
    return Random{Random{m_rules.seed}.bits() ^ Random{place}.bits()}.bits();
}

int PlantPattern::wanted(const glm::ivec2& square) const
{
    const double count = m_rules.density * m_side * m_side, whole = std::floor(count);
    return std::min(int(whole) + int(Random{seedOf(square)}.unit() < count - whole), m_most);
}

std::uint32_t PlantPattern::kindFor(double share) const
{
    const auto found = std::ranges::upper_bound(m_upTo, share * m_upTo.back());
    return std::uint32_t(std::min(found - m_upTo.begin(), std::ptrdiff_t(m_upTo.size()) - 1));
}

bool PlantPattern::hasRoom(const Grid& grid, const glm::ivec2& square, const PatternPoint& point) const
{
    const std::size_t kinds = m_rules.kinds.size();
    for (int z = std::max(square.y - 1, grid.from.y); z <= std::min(square.y + 1, grid.from.y + grid.size.y - 1); ++z)
        for (int x = std::max(square.x - 1, grid.from.x); x <= std::min(square.x + 1, grid.from.x + grid.size.x - 1); ++x) {
            const std::size_t index = grid.indexOf({x, z});
            const PatternPoint* other = grid.points.data() + index * std::size_t(grid.most);
            for (const PatternPoint* end = other + grid.counts[index]; other != end; ++other) {
                const glm::dvec2 way = other->at - point.at;
                if (glm::dot(way, way) < m_least[other->kind * kinds + point.kind]) return false;
            }
        }
    return true;
}

void PlantPattern::fill(Grid& grid, const glm::ivec2& square) const
{
    Random random{seedOf(square)};
    const int count = wanted(square);
    random.bits(); // told how many
    const glm::dvec2 low = glm::dvec2{square} * m_side;
    const std::size_t index = grid.indexOf(square);
    int& made = grid.counts[index];
    for (int tries = 0; made < count && tries < count * kTries; ++tries) {
        PatternPoint point{.square = square, .index = std::uint32_t(made)};
        point.at.x = random.unit();
        point.at.y = random.unit();
        point.at = glm::floor((low + point.at * m_side) / io::kInstanceStep) * io::kInstanceStep;
        point.kind = kindFor(random.unit());
        point.seed = random.bits();
        if (hasRoom(grid, square, point)) grid.points[index * std::size_t(grid.most) + std::size_t(made++)] = point;
    }
}

std::vector<PatternPoint> PlantPattern::points(const PlaneRect& part) const
{
    std::vector<PatternPoint> found;
    if (m_rules.density <= 0 || m_rules.kinds.empty() || part.low.x >= part.high.x || part.low.y >= part.high.y) return found;
    constexpr int kTurns = 4;
    const glm::ivec2 low = squareAt(part.low), high = squareAt(part.high); // inclusive: rounding may move a point into the next square
    Grid grid{.from = low - kTurns, .size = high - low + 1 + 2 * kTurns, .most = m_most, .counts = {}, .points = {}};
    const std::size_t squares = std::size_t(grid.size.x) * grid.size.y;
    grid.counts.resize(squares);
    grid.points.resize(squares * std::size_t(m_most));
    for (int turn = 0; turn < kTurns; ++turn) {
        const int beyond = kTurns - turn;
        for (int z = low.y - beyond; z <= high.y + beyond; ++z)
            for (int x = low.x - beyond; x <= high.x + beyond; ++x)
                if ((x & 1) + 2 * (z & 1) == turn) fill(grid, {x, z});
    }
    for (int z = low.y; z <= high.y + 1; ++z) // places are rounded down, so a point of the next square may lie in this part
        for (int x = low.x; x <= high.x + 1; ++x) {
            const std::size_t index = grid.indexOf({x, z});
            const PatternPoint* first = grid.points.data() + index * std::size_t(m_most);
            std::copy_if(first, first + grid.counts[index], std::back_inserter(found), [&](const PatternPoint& p) { return part.contains(p.at); });
        }
    return found;
}

} // namespace editor
