// The textures of all models and grounds, each painted once when it is first asked for.
#pragma once

#include "projects/make/canvas.h"

#include <map>
#include <string>
#include <string_view>

namespace make {

struct Texture {
    Picture colour; // sRGB; with alpha for leaves
    Picture normal; // null for leaves
};

class Textures {
public:
    // A name of paintings(): "leaf_oak", "bark_fir", "rock", "ground_grass" …
    const Texture& get(std::string_view name);

private:
    std::map<std::string, Texture, std::less<>> m_done;
};

// The painters, by file. Each is given its own fixed seed.
Canvas paintLeafCard(std::string_view name); // leaf_oak leaf_birch leaf_beech and their _autumn, leaf_fir leaf_bush …
Canvas paintPlant(std::string_view name, int size); // leaf_grass leaf_grass_dry leaf_fern leaf_flowers
Canvas paintBark(std::string_view name);            // bark_oak bark_birch bark_beech bark_fir bark_dead
Canvas paintGround(std::string_view name);          // ground_grass ground_forest ground_pebbles ground_rock ground_dry
Canvas paintMaterial(std::string_view name);        // rock rock_mossy wood_rings planks thatch canvas iron ash cloth

} // namespace make
