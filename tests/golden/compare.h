// How far two pictures are from each other, and the picture of it.
#pragma once

#include "io/scene/image.h"

namespace test {

struct Difference {
    double mean = 0;     // of all channels, 0..255
    double outliers = 0; // share of pixels of which a channel is further off than `far`
    io::Image picture;   // black where they are equal, else the difference times 8
};

constexpr int kFar = 24; // of 255

// Both U8 of one size and 3 or 4 channels; alpha does not count.
Difference compare(const io::Image& a, const io::Image& b);

} // namespace test
