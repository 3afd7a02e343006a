#include "io/scene/shadow_ends.h"

#include "io/scene/field_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace io {
namespace {

constexpr float kLeast = 1;       // m, of an end and between two that are pushed; the least that a field of them takes
constexpr float kFarthest = 5000; // m, the most that one takes

// Those that count, the last of them the distance.
std::vector<float*> endsOf(Shadows& s)
{
    const std::array<float*, 5> byHand{&s.end1, &s.end2, &s.end3, &s.end4, &s.end5};
    std::vector<float*> ends{byHand.begin(), byHand.begin() + std::clamp(s.cascades - 1, 0, 5)};
    ends.push_back(&s.distance);
    return ends;
}

std::string keyOf(std::size_t index, std::size_t count)
{
    return index + 1 == count ? "distance" : "end_" + std::to_string(index + 1);
}

EndFault faultOf(const std::vector<float*>& ends, std::size_t near, std::size_t far)
{
    return {keyOf(far, ends.size()),
            numberText(*ends[far]) + " m must be beyond " + keyOf(near, ends.size()) + ", " + numberText(*ends[near]) + " m"};
}

} // namespace

std::optional<EndFault> endFault(const Shadows& shadows)
{
    if (shadows.splits != Splits::Manual) return {};
    Shadows copy = shadows;
    const std::vector<float*> ends = endsOf(copy);
    for (std::size_t i = 1; i < ends.size(); ++i)
        if (!(*ends[i] > *ends[i - 1]))
            return faultOf(ends, i - 1, i);
    return {};
}

void pushEnds(Shadows& shadows, std::string_view kept)
{
    if (!endFault(shadows)) return;
    const std::vector<float*> ends = endsOf(shadows);
    std::size_t fixed = ends.size() - 1;
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (keyOf(i, ends.size()) == kept) fixed = i;
    // There must be room for those before it, and for those after it up to the distance, which no end pushes.
    const std::size_t after = ends.size() - 1 - fixed;
    const float most = after == 0 ? kFarthest : *ends.back() - kLeast * float(after);
    *ends[fixed] = std::clamp(*ends[fixed], kLeast * float(fixed + 1), std::max(most, kLeast * float(fixed + 1)));
    for (std::size_t i = fixed + 1; i + 1 < ends.size(); ++i)
        *ends[i] = std::max(*ends[i], *ends[i - 1] + kLeast);
    for (std::size_t i = fixed; i-- > 0;)
        *ends[i] = std::clamp(*ends[i], kLeast * float(i + 1), *ends[i + 1] - kLeast);
}

void spreadEnds(Shadows& shadows)
{
    (void)spreadEnds(shadows, {});
}

std::optional<EndFault> spreadEnds(Shadows& shadows, std::span<const std::string_view> kept)
{
    if (!endFault(shadows)) return {};
    const std::vector<float*> ends = endsOf(shadows);
    std::vector<std::size_t> fixed; // those of the keys, in their order, and the last
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (i + 1 == ends.size() || std::ranges::find(kept, keyOf(i, ends.size())) != kept.end()) fixed.push_back(i);
    if (std::ranges::find(kept, "distance") == kept.end() && fixed.size() > 1)
        *ends.back() = std::min(std::max(*ends.back(), *ends[fixed[fixed.size() - 2]] + kLeast), kFarthest);
    for (std::size_t i = 1; i < fixed.size(); ++i)
        if (!(*ends[fixed[i]] > *ends[fixed[i - 1]])) return faultOf(ends, fixed[i - 1], fixed[i]);
    float before = 0; // the last one that stays
    std::size_t next = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const std::size_t beyond = *std::ranges::lower_bound(fixed, i);
        if (i != beyond && !(*ends[i] > before && *ends[i] < *ends[beyond])) continue;
        const float from = std::max(before, std::min(kLeast, *ends[i] / 2));
        for (std::size_t k = next; k < i; ++k)
            *ends[k] = from * std::pow(*ends[i] / from, float(k - next + 1) / float(i - next + 1));
        before = *ends[i];
        next = i + 1;
    }
    return {};
}

} // namespace io
