#include "editor/ground_edits.h"

#include "editor/ground_recipe.h"
#include "editor/scatter_steps.h"
#include "io/files/height_map_file.h"
#include "io/scene/resampling.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace editor {
namespace {

constexpr float kFarthest = 1e5f; // m, up and down

// "terrain/NAME.png", or with a number where there is one already.
std::string freshFile(const Document& document, const std::string& stem, const std::string& extension)
{
    std::string file = stem + extension;
    std::error_code fault; // what cannot be looked at is not overwritten either
    for (int i = 2; std::filesystem::exists(document.project().folder / file, fault) || fault; ++i)
        file = stem + "_" + std::to_string(i) + extension, fault.clear();
    return file;
}

void nameFiles(const Document& document, io::Terrain& terrain, bool cover)
{
    const std::filesystem::path old{terrain.heightMap};
    const bool shared = document.project().scenes.size() > 1;
    if (terrain.heightMap.empty() || shared) {
        const std::string extension = io::holdsHeights(old) ? old.extension().string() : ".png";
        terrain.heightMap = freshFile(document, "terrain/" + document.world().entry.name, extension);
    }
    const std::filesystem::path heights{terrain.heightMap};
    if (!cover)
        terrain.coverMap.clear();
    else if (terrain.coverMap.empty() || shared)
        terrain.coverMap = freshFile(document, (heights.parent_path() / heights.stem()).generic_string() + "_cover", ".png");
}

void lift(Document& document, const std::string& name, const io::HeightMap& before)
{
    const io::HeightMap& now = *document.scene().heights();
    const auto rise = [&](const io::Object& object) {
        const glm::dvec3& p = object.transform.position;
        const auto old = before.height(p.x, p.z), risen = now.height(p.x, p.z);
        return old && risen ? *risen - *old : 0.0;
    };
    std::vector<io::ObjectId> ids;
    for (const io::Object& object : document.scene().objects())
        if (rise(object) != 0) ids.push_back(object.id);
    if (!ids.empty()) edit(document, name, ids, [&](io::Object& object) { object.transform.position.y += rise(object); });
}

// The texel of a map that stands for one beyond it.
glm::ivec2 brought(const glm::ivec2& texel, const glm::ivec2& size, GroundEdge edge)
{
    if (edge == GroundEdge::Wrap) return (texel % size + size) % size;
    return glm::clamp(texel, glm::ivec2{0}, size - 1);
}

// The map of grass, as far along as the ground went.
void moveGrass(Document& document, const std::string& name, const glm::dvec2& metres, GroundEdge edge)
{
    const auto map = document.scene().grassMap();
    const glm::ivec2 by{map ? glm::round(metres / map->metresPerTexel) : glm::dvec2{0}};
    if (by == glm::ivec2{0}) return;
    const glm::ivec2 size = map->size();
    const std::vector<std::uint32_t> moved = io::gathered<std::uint32_t>(map->field().read(map->field().rect()), size, size, [&](int x, int z) { return brought(glm::ivec2{x, z} - by, size, edge); });
    setGrassMap(document, name, std::make_shared<const io::GrassMap>(map->with(map->field().with(moved, size, {0, 0}))), map->field().rect());
}

PlaneRect boundsOf(const io::HeightMap& map)
{
    return {map.origin, map.origin + glm::dvec2{map.size - 1} * map.metresPerTexel};
}

struct Source {
    io::HeightGrid heights;
    const io::CoverMap* cover; // null: none
};

// Texels of the old ground in the place of new ones; at(x, z) names them.
template <class At> NewGround gatheredFrom(const Source& source, glm::ivec2 to, At&& at)
{
    const io::HeightGrid& old = source.heights;
    NewGround ground{.heights = {.size = to, .metres = io::gathered<float>(old.metres, old.size, to, at), .metresPerTexel = old.metresPerTexel, .origin = old.origin}};
    if (source.cover) {
        const std::vector<std::uint32_t> texels = source.cover->read(source.cover->rect());
        ground.cover = std::make_shared<const io::CoverMap>(to, io::gathered<std::uint32_t>(texels, old.size, to, at));
    }
    return ground;
}

io::Result<NewGround> resampledGround(const Source& source, const Reshaping& r)
{
    const io::HeightGrid& old = source.heights;
    if ((r.width > 0) == (r.metresPerTexel > 0)) return io::Error{{}, "needs either width or metres_per_texel"};
    if (r.width == 1) return io::Error{{}, "width: ground has at least 2 texels to a side"};
    const glm::dvec2 extent = glm::dvec2{old.size - 1} * old.metresPerTexel;
    const double metres = r.width > 0 ? extent.x / (r.width - 1) : r.metresPerTexel;
    const glm::dvec2 count = glm::round(extent / metres) + 1.0;
    if (count.x < 2 || count.y < 2) return io::Error{{}, "metres_per_texel: leaves less than 2 texels to a side"};
    if (count.x > kMostSide || count.y > kMostSide)
        return io::Error{{}, (r.width > 0 ? "width: makes " : "metres_per_texel: makes ") + std::to_string(std::int64_t(std::max(count.x, count.y))) +
                                 " texels to a side; at most " + std::to_string(kMostSide) + " can be"};
    const glm::ivec2 size{count};
    const double step = metres / old.metresPerTexel;
    NewGround ground{.heights = io::resampled(old, size, metres, old.origin)};
    if (source.cover) {
        const auto nearest = [&](int x, int z) { return glm::min(glm::ivec2{glm::round(glm::dvec2{x, z} * step)}, old.size - 1); };
        ground.cover = std::make_shared<const io::CoverMap>(size, io::gathered<std::uint32_t>(source.cover->read(source.cover->rect()), old.size, size, nearest));
    }
    return ground;
}

io::Result<NewGround> croppedGround(const Source& source, const Reshaping& r)
{
    const io::HeightGrid& old = source.heights;
    const auto texelOf = [&](const glm::dvec2& p) { return r.texels ? p : (p - old.origin) / old.metresPerTexel; };
    constexpr double kNearly = 1e-6; // of a texel: what metres lose on the way to texels
    const glm::dvec2 a = texelOf(glm::min(r.from, r.to)), b = texelOf(glm::max(r.from, r.to));
    const glm::dvec2 first = glm::ceil(a - kNearly), count = glm::floor(b + kNearly) + 1.0 - first;
    if (count.x < 2 || count.y < 2) return io::Error{{}, "from, to: hold less than 2 texels to a side"};
    if (count.x > kMostSide || count.y > kMostSide)
        return io::Error{{}, "from, to: make " + std::to_string(std::int64_t(std::max(count.x, count.y))) + " texels to a side; at most " + std::to_string(kMostSide) + " can be"};
    const glm::ivec2 low{first}, size{count};
    if (glm::any(glm::greaterThanEqual(low, old.size)) || glm::any(glm::lessThanEqual(low + size, glm::ivec2{0}))) return io::Error{{}, "from, to: hold nothing of the ground"};
    NewGround ground = gatheredFrom(source, size, [&](int x, int z) { return brought(low + glm::ivec2{x, z}, old.size, r.edge); });
    ground.heights.origin = old.origin + glm::dvec2{low} * old.metresPerTexel;
    return ground;
}

io::Result<NewGround> movedGround(const Source& source, const Reshaping& r)
{
    const glm::ivec2 size = source.heights.size;
    const glm::dvec2 texels = glm::round(r.texels ? r.by : r.by / source.heights.metresPerTexel);
    const glm::ivec2 by{r.edge == GroundEdge::Wrap ? texels - glm::floor(texels / glm::dvec2{size}) * glm::dvec2{size} : glm::clamp(texels, -glm::dvec2{size}, glm::dvec2{size})};
    NewGround ground = gatheredFrom(source, size, [&](int x, int z) {
        return brought(glm::ivec2{x, z} - by, size, r.edge);
    });
    ground.movedBy = glm::dvec2{by} * source.heights.metresPerTexel;
    ground.edge = r.edge;
    if (r.raise != 0)
        for (float& metres : ground.heights.metres)
            metres = std::clamp(float(double(metres) + r.raise), -kFarthest, kFarthest);
    return ground;
}

} // namespace

void replaceGround(Document& document, const std::string& name, NewGround ground, bool objectsFollow)
{
    const Gesture gesture{document, name};
    const std::shared_ptr<const io::HeightMap> before = document.scene().heights();
    io::Terrain terrain = document.scene().terrain();
    nameFiles(document, terrain, ground.cover != nullptr);
    terrain.metresPerTexel = ground.heights.metresPerTexel;
    terrain.origin = ground.heights.origin;
    if (ground.range) {
        terrain.minHeight = ground.range->x;
        terrain.maxHeight = ground.range->y;
    }
    const std::string extension = std::filesystem::path{terrain.heightMap}.extension().string();
    document.run(std::make_unique<SwapTerrain>(name, std::move(terrain)));
    io::HeightMap map{ground.heights};
    map.shares = before ? before->shares : extension == ".png";
    const io::TexelRect all = map.texels();
    setHeights(document, name, std::make_shared<const io::HeightMap>(std::move(map)), all);
    setCover(document, name, std::move(ground.cover), all);
    moveGrass(document, name, ground.movedBy, ground.edge);
    if (objectsFollow && before) {
        lift(document, name, *before);
        liftPlants(document, name, *before, boundsOf(*before));
    }
    followRules(document, name, PlantRegion::everywhere().bounds());
}

io::Result<NewGround> reshaped(const io::Scene& scene, const Reshaping& reshaping)
{
    const auto& heights = scene.heights();
    if (!heights) return io::Error{{}, "this scene has no ground"};
    for (const double number : {reshaping.metresPerTexel, reshaping.from.x, reshaping.from.y, reshaping.to.x, reshaping.to.y, reshaping.by.x, reshaping.by.y, reshaping.raise})
        if (!(std::abs(number) <= 1e7)) return io::Error{{}, "a number is too large, or none"};
    if (reshaping.width < 0 || reshaping.metresPerTexel < 0) return io::Error{{}, "width, metres_per_texel: must be above 0"};
    const Source source{heights->read(heights->texels()), scene.cover().get()};
    switch (reshaping.kind) {
    case Reshape::Resample: return resampledGround(source, reshaping);
    case Reshape::Crop: return croppedGround(source, reshaping);
    default: return movedGround(source, reshaping);
    }
}

} // namespace editor
