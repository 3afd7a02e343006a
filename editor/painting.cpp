#include "editor/painting.h"

#include "io/base/contract.h"
#include "io/files/file_names.h"

#include <cmath>
#include <filesystem>

namespace editor {
namespace {

constexpr double kGrassTexel = 1;         // m
constexpr double kMostGrassTexels = 8192; // along a side

} // namespace

io::CoverMap coverOf(const io::Scene& scene)
{
    EXPECTS(scene.heights());
    return scene.cover() ? *scene.cover() : io::CoverMap{scene.heights()->size};
}

namespace {

// A name beside the heights' that no file has.
std::string fileBesideHeights(const Document& document, const char* what)
{
    namespace fs = std::filesystem;
    const std::string& named = document.scene().terrain().heightMap;
    const fs::path heights = named.empty() ? fs::path{"terrain/heights.png"} : fs::path{named};
    const fs::path beside = heights.parent_path() / (heights.stem().string() + what + ".png");
    std::error_code fault; // what cannot be looked at is not overwritten either
    if (!fs::exists(document.project().folder / beside, fault) && !fault) return beside.generic_string();
    return io::freshFile(document.project().folder, beside, ".png");
}

} // namespace

void changeCover(Document& document, const std::string& name, const CoverPatch& patch)
{
    const Gesture gesture{document, name};
    const io::Scene& scene = document.scene();
    if (!scene.cover()) {
        io::Terrain terrain = scene.terrain();
        terrain.coverMap = fileBesideHeights(document, "_cover");
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
    EXPECTS(setTerrain(document, name, std::move(terrain))); // its heights are the same
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

io::GrassMap grassMapOf(const io::Scene& scene)
{
    EXPECTS(scene.heights());
    if (scene.grassMap()) return *scene.grassMap();
    const io::HeightMap& ground = *scene.heights();
    const glm::dvec2 metres = glm::dvec2{ground.size - 1} * ground.metresPerTexel;
    const double texel = std::max(kGrassTexel, std::max(metres.x, metres.y) / kMostGrassTexels);
    return {io::TexelTiles<std::uint32_t>{glm::ivec2{glm::ceil(metres / texel)} + 1}, texel, ground.origin};
}

void changeGrassMap(Document& document, const std::string& name, const CoverPatch& patch)
{
    const Gesture gesture{document, name};
    const io::GrassMap map = grassMapOf(document.scene());
    if (!document.scene().grassMap()) {
        io::Grass grass = document.scene().grass();
        grass.map = fileBesideHeights(document, "_grass");
        grass.metresPerTexel = map.metresPerTexel;
        grass.origin = map.origin;
        document.run(std::make_unique<SwapGrass>(name, std::move(grass)));
    }
    setGrassMap(document, name, std::make_shared<const io::GrassMap>(map.with(map.field().with(patch.texels, patch.size, patch.at))), patch.rect());
}

void fillGrass(Document& document, const std::string& name, const Brush& brush)
{
    const io::Scene& scene = document.scene();
    if (!scene.heights()) return;
    if (const auto patch = growOn(*scene.heights(), grassMapOf(scene), brush, {.amount = 1}, true)) changeGrassMap(document, name, *patch);
}

void setGrassKinds(Document& document, const std::string& name, std::vector<io::GrassKind> kinds, std::span<const int> newNumbers)
{
    const Gesture gesture{document, name};
    io::Grass grass = document.scene().grass();
    grass.kinds = std::move(kinds);
    setGrass(document, name, std::move(grass));
    const std::shared_ptr<const io::GrassMap> map = document.scene().grassMap();
    if (!map) return;
    std::vector<std::uint32_t> texels = map->field().read(map->field().rect());
    for (std::uint32_t& texel : texels) {
        if (texel == 0) continue;
        io::GrassCover cover = io::unpackedGrass(texel);
        for (const int i : {0, 1}) {
            const auto old = std::size_t(cover.kind[i]);
            const int now = old < newNumbers.size() ? newNumbers[old] : int(old);
            if (now < 0 || now >= io::kMostGrassKinds) cover.density[i] = 0;
            else cover.kind[i] = now;
        }
        texel = io::packed(cover);
    }
    setGrassMap(document, name, std::make_shared<const io::GrassMap>(map->with({map->size(), texels})), map->field().rect());
}

} // namespace editor
