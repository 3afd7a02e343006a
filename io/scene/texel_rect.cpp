#include "io/scene/texel_rect.h"

#include <algorithm>

namespace io {
namespace {

std::int64_t floorTo(std::int64_t value, std::int64_t period)
{
    const std::int64_t rest = value % period;
    return value - (rest < 0 ? rest + period : rest);
}

} // namespace

TexelRect common(const TexelRect& a, const TexelRect& b)
{
    const TexelRect both{glm::max(a.low, b.low), glm::min(a.high, b.high)};
    return both.empty() ? TexelRect{} : both;
}

TexelRect around(const TexelRect& a, const TexelRect& b)
{
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

std::vector<TexelRect> without(const TexelRect& whole, const TexelRect& hole)
{
    const TexelRect cut = common(whole, hole);
    if (cut.empty()) return whole.empty() ? std::vector<TexelRect>{} : std::vector{whole};
    std::vector<TexelRect> rest;
    const auto add = [&](const TexelRect& rect) {
        if (!rect.empty()) rest.push_back(rect);
    };
    add({whole.low, {whole.high.x, cut.low.y}});
    add({{whole.low.x, cut.high.y}, whole.high});
    add({{whole.low.x, cut.low.y}, {cut.low.x, cut.high.y}});
    add({{cut.high.x, cut.low.y}, {whole.high.x, cut.high.y}});
    return rest;
}

std::vector<TexelRect> cutAtMultiples(const TexelRect& rect, std::int64_t period)
{
    std::vector<TexelRect> pieces;
    for (std::int64_t y = floorTo(rect.low.y, period); y < rect.high.y; y += period)
        for (std::int64_t x = floorTo(rect.low.x, period); x < rect.high.x; x += period) {
            const TexelRect piece = common(rect, {{x, y}, {x + period, y + period}});
            if (!piece.empty()) pieces.push_back(piece);
        }
    return pieces;
}

} // namespace io
