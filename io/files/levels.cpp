#include "io/files/levels.h"

#include "io/base/log.h"
#include "io/base/paths.h"
#include "io/files/atomic_file.h"
#include "io/files/cache_folder.h"
#include "io/files/draw_order.h"
#include "io/files/level_cache.h"
#include "io/files/level_foliage.h"
#include "io/files/level_solid.h"

#include <algorithm>
#include <cmath>

namespace io {
namespace fs = std::filesystem;
namespace {

constexpr float kShares[] = {0.5f, 0.25f, 0.125f, 0.0625f, 0.03125f};
constexpr std::size_t kSmallModel = 64; // triangles; fewer are not worth a level
constexpr std::size_t kSmallLevel = 16; // triangles; nothing coarser follows
constexpr float kGain = 0.75f;          // a level has at most this share of the one before
constexpr float kRise = 1.01f;          // errors of neighbours differ, so that a choice by error is one
constexpr std::uint64_t kMostBytes = std::uint64_t(1) << 30; // of all levels on disk

Level levelOf(const Model& model, const levels::Piece& solid, const levels::Piece& foliage)
{
    Level level{.error = std::max(solid.error, foliage.error)};
    for (std::uint32_t number = 0; number < model.parts.size(); ++number) {
        Part part{.firstIndex = std::uint32_t(level.indices.size()), .material = model.parts[number].material};
        for (const levels::Piece* piece : {&solid, &foliage}) {
            const auto byPart = [](const levels::Corners& corners) { return corners.part; };
            const auto own = std::ranges::equal_range(piece->triangles, number, {}, byPart);
            for (const levels::Corners& corners : own)
                level.indices.insert(level.indices.end(), corners.vertex.begin(), corners.vertex.end());
        }
        part.indexCount = std::uint32_t(level.indices.size()) - part.firstIndex;
        if (part.indexCount > 0) level.parts.push_back(part);
    }
    return level;
}

// What the leaves' error allows anyway, the wood may take too.
levels::Piece solidFor(Model& model, levels::Solid& solid, float share, float leavesError)
{
    levels::Piece best = solid.simplified(model, share, leavesError);
    while (best.error < leavesError && best.triangles.size() > kSmallLevel) {
        share /= 2;
        levels::Piece next = solid.simplified(model, share, leavesError);
        if (next.error > leavesError || next.triangles.size() >= best.triangles.size()) break;
        best = std::move(next);
    }
    return best;
}

void fillLevels(Model& model)
{
    const std::vector<std::uint32_t> places = levels::placesOf(model);
    const levels::Foliage foliage{model, places};
    levels::Solid solid{model, places, foliage};
    std::size_t last = model.triangles();
    float error = 0;
    for (const float share : kShares) {
        if (last <= kSmallLevel) break;
        const levels::Piece leaves = foliage.thinned(model, share);
        const levels::Piece rest = solidFor(model, solid, share, leaves.error);
        const std::size_t count = leaves.triangles.size() + rest.triangles.size();
        if (count == 0 || float(count) > kGain * float(last)) continue;
        Level level = levelOf(model, rest, leaves);
        if (!std::isfinite(level.error)) break;
        level.error = error = std::max({level.error, error * kRise, 1e-6f});
        last = count;
        model.levels.push_back(std::move(level));
    }
}

// The full model's vertices stand before those that only levels use.
std::vector<std::uint32_t> make(Model& model)
{
    model.levels.clear();
    if (model.triangles() >= kSmallModel) fillLevels(model);
    return optimiseDrawOrder(model);
}

levels::Made madeOf(const Model& model, std::vector<std::uint32_t> order)
{
    const auto last = std::max_element(model.indices.begin(), model.indices.end());
    const std::size_t own = last == model.indices.end() ? 0 : *last + std::size_t{1};
    order.resize(own);
    return {.order = std::move(order),
            .added = {model.vertices.begin() + std::ptrdiff_t(own), model.vertices.end()},
            .indices = model.indices,
            .levels = model.levels};
}

} // namespace

void makeLevels(Model& model)
{
    make(model);
}

fs::path levelsFolder()
{
    return cacheFolder() / "levels";
}

void addLevels(Model& model, const fs::path& folder)
{
    if (model.triangles() < kSmallModel) return makeLevels(model);
    const levels::Key key = levels::keyOf(model);
    const fs::path file = folder / levels::fileName(key);
    if (const Result<std::string> bytes = readFile(file)) {
        if (std::optional<levels::Made> made = levels::decode(*bytes, key, model)) {
            markUsed(file);
            return levels::apply(std::move(*made), model);
        }
        log::debug("{}: damaged; its levels are made anew", file.string());
    }
    std::vector<std::uint32_t> order = make(model);
    if (!putAside(file, levels::encode(key, madeOf(model, std::move(order)))))
        log::debug("{}: cannot be written; levels of detail are made again next time", file.string());
    keepWithin(folder, file.extension().string(), kMostBytes);
}

} // namespace io
