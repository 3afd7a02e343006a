// Rectangles of texels, and what is left of one without another.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <vector>

namespace io {

using Texel = glm::i64vec2;

struct TexelRect {
    Texel low{0}, high{0}; // the first one, and one past the last
    bool empty() const { return high.x <= low.x || high.y <= low.y; }
    bool operator==(const TexelRect&) const = default;
};

TexelRect common(const TexelRect& a, const TexelRect& b);
TexelRect around(const TexelRect& a, const TexelRect& b); // the smallest that holds both

// `whole` without `hole`, as at most four rectangles that do not overlap.
std::vector<TexelRect> without(const TexelRect& whole, const TexelRect& hole);

// The same rectangle of a texture that repeats every `period` texels, cut where it wraps around: at most four pieces of one
// no larger than the period.
std::vector<TexelRect> cutAtMultiples(const TexelRect& rect, std::int64_t period);

} // namespace io
