// What the machine that draws is and can do. Needs a current context.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace renderer {

struct Device {
    std::string vendor, name, version, shadingLanguage;
    std::vector<std::pair<std::string, double>> limits; // "max_texture_size": 16384
    std::vector<std::string> extensions;                // those that are used when present, and are
};

Device describeDevice();
void waitForDevice(); // until all that was asked of it is done

} // namespace renderer
