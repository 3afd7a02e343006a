#include "editor/painting.h"

#include "io/base/contract.h"

#include <filesystem>

namespace editor {

io::CoverMap coverOf(const io::Scene& scene)
{
    EXPECTS(scene.heights());
    return scene.cover() ? *scene.cover() : io::CoverMap{scene.heights()->size};
}

void changeCover(Document& document, const std::string& name, const CoverPatch& patch)
{
    namespace fs = std::filesystem;
    const Gesture gesture{document, name};
    const io::Scene& scene = document.scene();
    if (!scene.cover()) {
        io::Terrain terrain = scene.terrain();
        const fs::path heights = terrain.heightMap.empty() ? fs::path{"terrain/heights.png"} : fs::path{terrain.heightMap};
        const std::string stem = (heights.parent_path() / heights.stem()).generic_string() + "_cover";
        std::error_code fault; // what cannot be looked at is not overwritten either
        terrain.coverMap = stem + ".png";
        for (int i = 2; fs::exists(document.project().folder / terrain.coverMap, fault) || fault; ++i)
            terrain.coverMap = stem + "_" + std::to_string(i) + ".png", fault.clear();
        document.run(std::make_unique<SwapTerrain>(name, std::move(terrain)));
    }
    setCover(document, name, std::make_shared<const io::CoverMap>(coverOf(scene).with(patch.texels, patch.size, patch.at)), patch.rect());
}

void fillCover(Document& document, const std::string& name, const Brush& brush)
{
    const io::Scene& scene = document.scene();
    if (!scene.heights()) return;
    if (const auto patch = paintOn(*scene.heights(), coverOf(scene), brush, {.amount = 1}, true)) changeCover(document, name, *patch);
}

void setLayers(Document& document, const std::string& name, std::vector<io::TerrainLayer> layers, std::span<const int> newNumbers)
{
    const Gesture gesture{document, name};
    io::Terrain terrain = document.scene().terrain();
    terrain.layers = std::move(layers);
    setTerrain(document, name, std::move(terrain));
    const auto& cover = document.scene().cover();
    if (!cover) return;
    const auto moved = [&](int layer) {
        const int number = layer < int(newNumbers.size()) ? newNumbers[std::size_t(layer)] : layer;
        return number < io::kMostLayers ? number : -1;
    };
    std::vector<std::uint32_t> texels = cover->read(cover->rect());
    for (std::uint32_t& texel : texels) {
        if (texel == 0) continue;
        io::Cover c = io::unpacked(texel);
        c.base = moved(c.base);
        c.over = moved(c.over);
        if (c.base < 0 && c.over < 0) c = {.hole = c.hole};
        if (c.base < 0) c.base = c.over; // what shows beside the one that is gone shows alone
        if (c.over < 0) c.over = c.base;
        texel = io::packed(c);
    }
    setCover(document, name, std::make_shared<const io::CoverMap>(cover->size(), texels), cover->rect());
}

} // namespace editor
