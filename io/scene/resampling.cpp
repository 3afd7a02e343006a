#include "io/scene/resampling.h"

#include <algorithm>

namespace io {
namespace {

// What one new texel takes along one axis.
struct Taps {
    int first = 0; // texel; may lie beyond the edge
    std::vector<double> weights;
};

// `at`: of the old texels; `step`: new width of a texel in old ones.
Taps tapsAt(double at, double step)
{
    if (step > 1) { // the mean of [at - step / 2, at + step / 2], where a texel reaches half a one to each side
        const double low = at - step / 2, high = at + step / 2;
        Taps taps{.first = int(std::floor(low + 0.5))};
        for (int i = taps.first; double(i) - 0.5 < high; ++i)
            taps.weights.push_back(std::max(0.0, std::min(high, i + 0.5) - std::max(low, i - 0.5)) / step);
        return taps;
    }
    const double base = std::floor(at), t = at - base;
    if (t == 0) return {int(base), {1}};
    return {int(base) - 1,
            {((2 - t) * t - 1) * t / 2, ((3 * t - 5) * t * t + 2) / 2, ((4 - 3 * t) * t + 1) * t / 2, (t - 1) * t * t / 2}};
}

std::vector<Taps> tapsOf(int count, double first, double step)
{
    std::vector<Taps> taps;
    for (int i = 0; i < count; ++i)
        taps.push_back(tapsAt(first + i * step, step));
    return taps;
}

// get(i) within [0, count), continued beyond by reflection in its first or last point.
template <class Get> double continued(int i, int count, Get&& get)
{
    if (i >= 0 && i < count) return get(i);
    const int edge = i < 0 ? 0 : count - 1;
    return 2 * get(edge) - get(std::clamp(2 * edge - i, 0, count - 1));
}

} // namespace

HeightGrid resampled(const HeightGrid& from, glm::ivec2 size, double metresPerTexel, glm::dvec2 origin)
{
    EXPECTS(from.size.x >= 2 && from.size.y >= 2 && size.x >= 1 && size.y >= 1 && metresPerTexel > 0);
    const double step = metresPerTexel / from.metresPerTexel;
    const glm::dvec2 first = (origin - from.origin) / from.metresPerTexel;
    HeightGrid to{.size = size, .metresPerTexel = metresPerTexel, .origin = origin};
    to.metres.resize(std::size_t(size.x) * std::size_t(size.y));

    const std::vector<Taps> across = tapsOf(size.x, first.x, step), along = tapsOf(size.y, first.y, step);
    std::vector<float> narrow(std::size_t(size.x) * std::size_t(from.size.y)); // new along x, old along z
    for (int z = 0; z < from.size.y; ++z)
        for (int x = 0; x < size.x; ++x) {
            const Taps& taps = across[std::size_t(x)];
            double sum = 0;
            for (std::size_t i = 0; i < taps.weights.size(); ++i)
                sum += taps.weights[i] * continued(taps.first + int(i), from.size.x, [&](int column) { return double(from.at(column, z)); });
            narrow[std::size_t(z) * std::size_t(size.x) + std::size_t(x)] = float(sum);
        }
    for (int z = 0; z < size.y; ++z) {
        const Taps& taps = along[std::size_t(z)];
        for (int x = 0; x < size.x; ++x) {
            double sum = 0;
            for (std::size_t i = 0; i < taps.weights.size(); ++i)
                sum += taps.weights[i] * continued(taps.first + int(i), from.size.y, [&](int row) {
                           return double(narrow[std::size_t(row) * std::size_t(size.x) + std::size_t(x)]);
                       });
            to.at(x, z) = float(sum);
        }
    }
    return to;
}

} // namespace io
