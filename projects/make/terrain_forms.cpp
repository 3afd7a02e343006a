#include "projects/make/terrain_forms.h"

#include "io/scene/rain.h"
#include "projects/make/random.h"

#include <algorithm>
#include <cmath>

namespace make {

io::HeightGrid blankHeights(int side, double metresPerTexel)
{
    io::HeightGrid map;
    map.size = {side, side};
    map.metresPerTexel = metresPerTexel;
    map.origin = glm::dvec2{-0.5 * (side - 1) * metresPerTexel};
    map.metres.assign(std::size_t(side) * side, 0.0f);
    return map;
}

void fill(io::HeightGrid& map, const std::function<float(glm::vec2)>& heights)
{
    change(map, [&](glm::vec2 p, float) { return heights(p); });
}

void change(io::HeightGrid& map, const std::function<float(glm::vec2, float)>& heights)
{
    for (int z = 0; z < map.size.y; ++z)
        for (int x = 0; x < map.size.x; ++x) {
            float& height = map.metres[std::size_t(z) * map.size.x + x];
            height = heights(glm::vec2{map.origin + glm::dvec2{x, z} * map.metresPerTexel}, height);
        }
}

namespace {

float cubic(float a, float b, float c, float d) // half way between b and c (Catmull-Rom)
{
    return (9 * (b + c) - a - d) / 16;
}

} // namespace

io::HeightGrid doubled(const io::HeightGrid& map)
{
    io::HeightGrid fine = blankHeights(map.size.x * 2 - 1, map.metresPerTexel / 2);
    const int side = fine.size.x;
    const auto out = [&](int x, int z) -> float& { return fine.metres[std::size_t(z) * side + x]; };
    for (int z = 0; z < map.size.y; ++z)
        for (int x = 0; x < side; ++x) {
            const int half = x / 2;
            out(x, 2 * z) = x % 2 == 0 ? map.at(half, z)
                                       : cubic(map.clampedAt(half - 1, z), map.at(half, z),
                                               map.clampedAt(half + 1, z), map.clampedAt(half + 2, z));
        }
    for (int z = 1; z < side; z += 2)
        for (int x = 0; x < side; ++x)
            out(x, z) =
                cubic(out(x, std::max(0, z - 3)), out(x, z - 1), out(x, z + 1), out(x, std::min(side - 1, z + 3)));
    return fine;
}

void rainOn(io::HeightGrid& map, const Rain& rain)
{
    io::Rainfall fall{map, {.steps = rain.steps, .reach = rain.brush, .strength = rain.strength}};
    Random random{rain.seed};
    for (int i = 0; i < rain.drops; ++i) {
        const float x = random.range(fall.first(), fall.last().x);
        fall.drop({x, random.range(fall.first(), fall.last().y)});
    }
}

float heightAt(const io::HeightGrid& map, glm::vec2 place)
{
    const glm::dvec2 low = map.origin, high = map.origin + glm::dvec2{map.size - 1} * map.metresPerTexel;
    const glm::dvec2 p = glm::clamp(glm::dvec2{place}, low, high);
    return float(map.height(p.x, p.y).value_or(0));
}

float slopeAt(const io::HeightGrid& map, glm::vec2 place)
{
    const auto normal = map.normal(place.x, place.y);
    return normal ? float(glm::degrees(std::acos(std::min(1.0, normal->y)))) : 90;
}

} // namespace make
