#include "io/scene/exposure_limits.h"

#include "io/scene/field_words.h"

#include <algorithm>

namespace io {

std::optional<std::string> limitsFault(const AutoExposure& exposure)
{
    if (exposure.lowest <= exposure.highest) return {};
    return numberText(decimal(exposure.highest)) + " EV must not be below lowest, " + numberText(decimal(exposure.lowest)) + " EV";
}

void pushLimits(AutoExposure& exposure, std::string_view kept)
{
    if (kept == "highest") exposure.lowest = std::min(exposure.lowest, exposure.highest);
    else exposure.highest = std::max(exposure.highest, exposure.lowest);
}

} // namespace io
