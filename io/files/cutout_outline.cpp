#include "io/files/cutout_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace io {
namespace {

// Twice the area of a triangle, positive with its inside to the left of a, b, c.
float turn(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Andrew's monotone chain (1979).
Polygon convexHull(std::vector<glm::vec2> points)
{
    std::sort(points.begin(), points.end(),
              [](const glm::vec2& a, const glm::vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    Polygon hull;
    const auto add = [&](const glm::vec2& point, std::size_t fixed) {
        while (hull.size() > fixed && turn(hull[hull.size() - 2], hull.back(), point) <= 0)
            hull.pop_back();
        hull.push_back(point);
    };
    for (const glm::vec2& point : points)
        add(point, 1);
    const std::size_t lower = hull.size();
    for (auto point = points.rbegin() + 1; point != points.rend(); ++point)
        add(*point, lower);
    hull.pop_back(); // the first again
    return hull;
}

constexpr std::size_t kMostEdges = 16;   // of a hull that outlines are chosen for; twice as many lines
constexpr std::size_t kMostCorners = 10; // of an outline

struct Line {
    glm::vec2 point{0}, along{0};
    std::size_t first = 0, last = 0; // the hull's corners on it
};

float cross(const glm::vec2& a, const glm::vec2& b)
{
    return a.x * b.y - a.y * b.x;
}

// Where the second line leaves the first, ahead of all that both touch; nothing when they do not turn towards each other.
std::optional<glm::vec2> meeting(const Line& a, const Line& b)
{
    const float across = cross(a.along, b.along);
    if (across < 1e-4f) return {};
    return a.point + a.along * (cross(b.point - a.point, b.along) / across);
}

bool inside(const glm::vec2& point, const OutlineRequest& request)
{
    constexpr float kRounding = 1e-5f;
    return glm::all(glm::greaterThanEqual(point, request.min - kRounding)) &&
           glm::all(glm::lessThanEqual(point, request.max + kRounding));
}

Line edgeOf(const Polygon& hull, std::size_t i)
{
    const std::size_t next = (i + 1) % hull.size();
    return {hull[i], glm::normalize(hull[next] - hull[i]), i, next};
}

// Takes away one edge after the other: that whose neighbours, made longer until they meet, enclose least more.
void dropEdges(Polygon& hull, const OutlineRequest& request)
{
    while (hull.size() > kMostEdges) {
        const std::size_t count = hull.size();
        std::size_t best = count;
        float least = 0;
        glm::vec2 corner{0};
        for (std::size_t i = 0; i < count; ++i) {
            const auto point = meeting(edgeOf(hull, (i + count - 1) % count), edgeOf(hull, (i + 1) % count));
            if (!point || !inside(*point, request)) continue;
            const float more = turn(hull[i], *point, hull[(i + 1) % count]);
            if (best < count && more >= least) continue;
            best = i, least = more, corner = *point;
        }
        if (best == count) return;
        hull[best] = corner;
        hull.erase(hull.begin() + std::ptrdiff_t((best + 1) % count));
    }
}

// What touches the hull, in the order of its turn: along each edge, and between two edges at their corner.
std::vector<Line> linesAround(const Polygon& hull)
{
    std::vector<Line> lines;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Line edge = edgeOf(hull, i), next = edgeOf(hull, (i + 1) % hull.size());
        lines.push_back(edge);
        lines.push_back({next.point, glm::normalize(edge.along + next.along), next.first, next.first});
    }
    return lines;
}

// A corner of an outline: one line left for another.
struct Corner {
    glm::vec2 point{0};
    float more = std::numeric_limits<float>::infinity(); // area between it and the hull; infinite: cannot be had
};

Corner cornerOf(const Polygon& hull, const Line& from, const Line& to, const OutlineRequest& request)
{
    const auto point = meeting(from, to);
    if (!point || !inside(*point, request)) return {};
    float twice = 0;
    for (std::size_t i = from.last; i != to.first; i = (i + 1) % hull.size())
        twice -= turn(*point, hull[i], hull[(i + 1) % hull.size()]);
    return {*point, std::max(twice, 0.0f) / 2};
}

// The outline of least area and corners among those whose edges lie on the lines: areas between hull and outline add up
// corner by corner, so that the best way round of so many corners grows from the best ways of fewer.
Polygon bestOutline(const Polygon& hull, const OutlineRequest& request)
{
    const std::vector<Line> lines = linesAround(hull);
    const std::size_t count = lines.size();
    std::vector<Corner> corners(count * count);
    for (std::size_t from = 0; from < count; ++from)
        for (std::size_t to = 0; to < count; ++to)
            corners[from * count + to] = cornerOf(hull, lines[from], lines[to], request);

    const glm::vec2 size = request.max - request.min;
    const float price = request.corner * size.x * size.y;
    float least = std::numeric_limits<float>::infinity();
    std::vector<std::size_t> best;
    for (std::size_t start = 0; start < count; ++start) { // the outline's line that comes first in the list
        struct Way {
            float more = std::numeric_limits<float>::infinity();
            std::size_t before = 0;
        };
        std::vector<std::vector<Way>> ways{std::vector<Way>(count)}; // by corners taken, then by the line reached
        ways[0][start].more = 0;
        for (std::size_t taken = 1; taken <= kMostCorners; ++taken) {
            std::vector<Way> next(count);
            for (std::size_t from = start; from < count; ++from)
                for (std::size_t to = from + 1; to < count; ++to) {
                    const float more = ways.back()[from].more + corners[from * count + to].more;
                    if (more < next[to].more) next[to] = {more, from};
                }
            for (std::size_t from = start + 1; from < count && taken > 1; ++from) { // and back to the first
                const float more = ways.back()[from].more + corners[from * count + start].more + price * float(taken);
                if (more >= least) continue;
                least = more;
                best = {from};
                for (std::size_t back = taken - 1; back > 0; --back)
                    best.push_back(ways[back][best.back()].before);
                std::reverse(best.begin(), best.end());
            }
            ways.push_back(std::move(next));
        }
    }
    if (best.empty()) return hull;
    Polygon outline;
    for (std::size_t i = 0; i < best.size(); ++i)
        outline.push_back(corners[best[i] * count + best[(i + 1) % best.size()]].point);
    return outline;
}

template <class T>
std::vector<glm::vec2> borderOf(const Image& image, const OutlineRequest& request, float one)
{
    const glm::vec2 size{image.size};
    const glm::ivec2 first = glm::max(glm::ivec2(glm::floor(request.min * size)), 0);
    const glm::ivec2 last = glm::min(glm::ivec2(glm::ceil(request.max * size)), image.size) - 1;
    const auto counts = [&](const T* row, int x) {
        return float(row[x * image.channels + image.channels - 1]) >= request.cutoff * one;
    };
    std::vector<glm::vec2> border;
    for (int y = first.y; y <= last.y; ++y) {
        const T* row = image.row<T>(y);
        int left = first.x, right = last.x;
        while (left <= last.x && !counts(row, left))
            ++left;
        if (left > last.x) continue;
        while (!counts(row, right))
            --right;
        for (const int x : {left, right + 1})
            for (const int side : {y, y + 1})
                for (const float dx : {-request.margin, request.margin})
                    for (const float dy : {-request.margin, request.margin})
                        border.push_back(glm::clamp(glm::vec2(x, side) / size + glm::vec2(dx, dy), request.min, request.max));
    }
    return border;
}

} // namespace

float areaOf(const Polygon& polygon)
{
    float twice = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        twice += turn(polygon[0], polygon[i - 1], polygon[i]);
    return twice / 2;
}

bool hasAlpha(const Image& image)
{
    return image.channels == 2 || image.channels == 4;
}

Polygon cutoutOutline(const Image& image, const OutlineRequest& request)
{
    if (!hasAlpha(image)) return {request.min, {request.max.x, request.min.y}, request.max, {request.min.x, request.max.y}};
    std::vector<glm::vec2> border = image.type == PixelType::U8    ? borderOf<std::uint8_t>(image, request, 255)
                                    : image.type == PixelType::U16 ? borderOf<std::uint16_t>(image, request, 65535)
                                                                   : borderOf<float>(image, request, 1);
    Polygon hull = convexHull(std::move(border));
    if (hull.size() < 3) return {};
    dropEdges(hull, request);
    return bestOutline(hull, request);
}

} // namespace io
