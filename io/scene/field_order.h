// Fields of the environment of which one must not be above another: the limits of the automatic exposure, and what haze scatters of
// what it takes away. (Ends of cascades, which are many in a row, are in shadow_ends.h.)
#pragma once

#include "io/scene/environment.h"

#include <string>
#include <string_view>
#include <vector>

namespace io {

struct OrderFault {
    std::string_view less, greater; // keys, as "auto_exposure.lowest"
    std::string what;               // is wrong with the greater
};
std::vector<OrderFault> orderFaults(const Environment& environment);
// The other one goes along with the field of that key; nothing where it is not one of these.
void keepOrder(Environment& environment, std::string_view kept);

} // namespace io
