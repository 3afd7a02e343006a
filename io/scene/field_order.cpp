#include "io/scene/field_order.h"

#include "io/scene/field_words.h"

#include <algorithm>

namespace io {
namespace {

struct Pair {
    std::string_view less, greater;
    const char* unit;
    float& (*lesser)(Environment&);
    float& (*greatest)(Environment&);
};
constexpr Pair kPairs[]{
    {"auto_exposure.lowest", "auto_exposure.highest", "EV", [](Environment& e) -> float& { return e.autoExposure.lowest; }, [](Environment& e) -> float& { return e.autoExposure.highest; }},
    {"sky.mie_scattering", "sky.mie_extinction", "1e-6/m", [](Environment& e) -> float& { return e.sky.mieScattering; }, [](Environment& e) -> float& { return e.sky.mieExtinction; }}};

} // namespace

std::vector<OrderFault> orderFaults(const Environment& environment)
{
    std::vector<OrderFault> faults;
    Environment e = environment;
    for (const Pair& pair : kPairs) {
        const float less = pair.lesser(e), greater = pair.greatest(e);
        if (less <= greater) continue;
        const std::string unit = std::string{" "} + pair.unit;
        faults.push_back({pair.less, pair.greater,
                          numberText(decimal(greater)) + unit + " must not be below " + std::string{pair.less.substr(pair.less.find('.') + 1)} + ", " + numberText(decimal(less)) + unit});
    }
    return faults;
}

void keepOrder(Environment& environment, std::string_view kept)
{
    for (const Pair& pair : kPairs) {
        float &less = pair.lesser(environment), &greater = pair.greatest(environment);
        if (kept == pair.less) greater = std::max(greater, less);
        if (kept == pair.greater) less = std::min(less, greater);
    }
}

} // namespace io
