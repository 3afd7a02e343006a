#include "projects/make/textures.h"

#include <algorithm>

namespace make {
namespace {

constexpr int kColourStep = 7;
constexpr int kNormalStep = 8;

Texture make(std::string_view name)
{
    if (name.starts_with("leaf_")) return {colourPicture(paintLeafCard(name), true, kColourStep), nullptr};
    if (name.starts_with("ground_")) { // kept as JPEG
        const Canvas canvas = paintGround(name);
        return {colourPicture(canvas, false, 1), normalPicture(canvas, 0.8f, 1)};
    }
    const Canvas canvas = name.starts_with("bark_") ? paintBark(name) : paintMaterial(name);
    return {colourPicture(canvas, false, kColourStep), normalPicture(halved(canvas), 1.0f, kNormalStep)};
}

} // namespace

const Texture& Textures::get(std::string_view name)
{
    const auto found = m_done.find(name);
    if (found != m_done.end()) return found->second;
    return m_done.emplace(std::string{name}, make(name)).first->second;
}

} // namespace make
