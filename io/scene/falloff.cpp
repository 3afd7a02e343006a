#include "io/scene/falloff.h"

#include <algorithm>

namespace io {

float falloffAt(std::span<const FalloffKey> keys, float at)
{
    if (keys.empty()) return (1 - at) * (1 - at);
    // Keys by rising place; a hand-written file may have them otherwise.
    const FalloffKey* before = nullptr;
    const FalloffKey* after = nullptr;
    for (const FalloffKey& key : keys) {
        if (key.at <= at && (!before || key.at >= before->at)) before = &key;
        if (key.at > at && (!after || key.at < after->at)) after = &key;
    }
    if (!before) return after->level;
    if (!after) return before->level;
    return glm::mix(before->level, after->level, (at - before->at) / (after->at - before->at));
}

std::size_t addFalloffKey(std::vector<FalloffKey>& keys, FalloffKey key)
{
    if (keys.empty()) keys = {{0, 1}, {1, 0}};
    const auto place = std::ranges::upper_bound(keys, key.at, {}, &FalloffKey::at);
    return std::size_t(keys.insert(place, key) - keys.begin());
}

void moveFalloffKey(std::vector<FalloffKey>& keys, std::size_t index, FalloffKey to)
{
    if (index >= keys.size()) return;
    const float least = index > 0 ? keys[index - 1].at : 0;
    const float most = index + 1 < keys.size() ? keys[index + 1].at : 1;
    keys[index] = {std::clamp(to.at, std::min(least, most), most), std::clamp(to.level, 0.0f, 1.0f)};
}

} // namespace io
