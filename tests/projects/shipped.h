// A world that ships, opened from the source tree with all it names.
#pragma once

#include "io/files/project.h"

#include <string_view>

namespace tests {

struct Shipped {
    io::World world;
    io::Assets assets;
    io::Complaints complaints;

    const io::Scene& scene() const { return world.scene; }
};

const Shipped& shipped(std::string_view name); // opened once a program

} // namespace tests
