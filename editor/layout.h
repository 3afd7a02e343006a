// The layout of the window as plain data: which panels lie in which region, in what order, and how large it is.
#pragma once

#include "io/base/value.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace editor {

enum class Region { Left, Right, Bottom, Centre };
inline constexpr std::array kRegions{Region::Left, Region::Right, Region::Bottom, Region::Centre};
std::string_view name(Region region);

struct Tabs {
    std::vector<std::string> panels; // ids, in order
    std::string front;               // of those; empty when there are none
    float size = 0;                  // pixels, width of left and right, height of bottom
    bool operator==(const Tabs&) const = default;
};

struct Layout {
    std::array<Tabs, 4> regions; // by Region
    std::vector<std::string> hidden;

    Tabs& at(Region region) { return regions[std::size_t(region)]; }
    const Tabs& at(Region region) const { return regions[std::size_t(region)]; }
    bool shows(std::string_view panel) const;
    void take(std::string_view panel);                                                    // out of wherever it is
    void put(std::string_view panel, Region region, std::size_t place = ~std::size_t(0)); // and in front
    void hide(std::string_view panel);
    bool operator==(const Layout&) const = default;
};

io::Value toValue(const Layout& layout);
// What `saved` says of the panels that `home` knows; the rest, and what makes no sense, stays as at home.
Layout layoutFrom(const io::Value& saved, const Layout& home);

} // namespace editor
