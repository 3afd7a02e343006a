// How fast the machine draws, by three small passes: a tenth of a second at most. Needs a current context.
#pragma once

namespace renderer {

struct DeviceSpeed {
    double triangles = 0;  // a second, small ones in instanced boxes
    double arithmetic = 0; // floating-point operations a second, of a fragment shader
    double taps = 0;       // filtered texture samples a second
};

DeviceSpeed measureDevice(); // zeros where something does not compile

} // namespace renderer
