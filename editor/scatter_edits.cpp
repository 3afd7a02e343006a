#include "editor/scatter_edits.h"

#include "io/base/in_parallel.h"
#include "io/base/random.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

namespace editor {
namespace {

constexpr int kBlock = 4; // tiles along a side that are worked out together
constexpr double kMostMarked = 20'000; // m; of wider regions only squares are marked in which something stood

struct TileRect { // both ends included
    glm::ivec2 low, high;
};

TileRect tilesOf(const PlaneRect& rect)
{
    return {glm::ivec2{glm::floor(rect.low / double(io::kInstanceTile))}, glm::ivec2{glm::floor(rect.high / double(io::kInstanceTile))}};
}

PlaneRect rectOf(const TileRect& tiles)
{
    return {glm::dvec2{tiles.low} * double(io::kInstanceTile), glm::dvec2{tiles.high + 1} * double(io::kInstanceTile)};
}

glm::dvec2 placeOf(const glm::ivec2& tile, const io::Instance& instance)
{
    return glm::dvec2{tile} * double(io::kInstanceTile) + glm::dvec2{instance.x, instance.z} * io::kInstanceStep;
}

// Those that are there, whichever way that is fewer steps.
void eachTile(const io::InstanceTiles& tiles, const TileRect& rect, auto&& visit)
{
    const glm::dvec2 count = glm::dvec2{rect.high} - glm::dvec2{rect.low} + 1.0;
    if (count.x * count.y > double(tiles.size())) {
        for (const auto& [place, tile] : tiles)
            if (place.x >= rect.low.x && place.x <= rect.high.x && place.y >= rect.low.y && place.y <= rect.high.y) visit(place, *tile);
        return;
    }
    for (int z = rect.low.y; z <= rect.high.y; ++z)
        for (int x = rect.low.x; x <= rect.high.x; ++x)
            if (const auto found = tiles.find({x, z}); found != tiles.end()) visit(found->first, *found->second);
}

Standing standingIn(const LayerTiles& layer, const PlantPattern& pattern, PlaneRect part, bool paintedOnly)
{
    Standing standing{pattern};
    part = {part.low - 2 * pattern.side(), part.high + 2 * pattern.side()};
    eachTile(layer.tiles, tilesOf(part), [&](const glm::ivec2& place, const io::InstanceTile& tile) {
        for (const io::Instance& instance : tile.instances)
            if (!paintedOnly || (instance.flags & io::kPaintedInstance))
                if (const glm::dvec2 at = placeOf(place, instance); part.contains(at)) standing.add(at, instance.species);
    });
    return standing;
}

// A tile in the making, begun as a copy of the one that is there.
class NewTiles {
public:
    explicit NewTiles(const io::InstanceTiles& before) : m_before{before} {}
    io::InstanceTile& at(const glm::ivec2& place)
    {
        const auto [made, isNew] = m_made.try_emplace(place);
        if (isNew)
            if (const auto found = m_before.find(place); found != m_before.end()) made->second = *found->second;
        return made->second;
    }
    void moveTo(InstanceSlots& slots, io::ScatterId layer)
    {
        for (auto& [place, tile] : m_made) {
            const auto found = m_before.find(place);
            if (found == m_before.end() ? tile.empty() : *found->second == tile) continue;
            slots.emplace_back(io::LayerTile{layer, place}, tile.empty() ? nullptr : std::make_shared<const io::InstanceTile>(std::move(tile)));
        }
    }

private:
    const io::InstanceTiles& m_before;
    std::map<glm::ivec2, io::InstanceTile, io::TileOrder> m_made;
};

std::size_t counted(const io::InstanceTiles& tiles, const PlantRegion& region, auto&& means)
{
    std::size_t count = 0;
    eachTile(tiles, tilesOf(region.bounds()), [&](const glm::ivec2& place, const io::InstanceTile& tile) {
        for (const io::Instance& instance : tile.instances)
            count += means(instance) && region.contains(placeOf(place, instance));
    });
    return count;
}

// change(tile's place, instance) answers false for one that goes.
InstanceSlots edited(const LayerTiles& layer, const PlantRegion& region, auto&& change)
{
    InstanceSlots slots;
    eachTile(layer.tiles, tilesOf(region.bounds()), [&](const glm::ivec2& place, const io::InstanceTile& tile) {
        io::InstanceTile now = tile;
        std::vector<io::Instance> gone;
        std::erase_if(now.instances, [&](io::Instance& instance) {
            const bool goes = layer.means(instance) && region.contains(placeOf(place, instance)) && !change(place, instance);
            if (goes) gone.push_back(instance);
            return goes;
        });
        if (layer.rule)
            for (const io::Instance& instance : gone)
                markErased(now, instance);
        if (layer.rule && !gone.empty()) // what stays in such a square stays by hand
            for (io::Instance& instance : now.instances)
                if (isErased(now, instance)) instance.flags |= io::kPaintedInstance;
        if (now == tile) return;
        slots.emplace_back(io::LayerTile{layer.layer, place}, now.empty() ? nullptr : std::make_shared<const io::InstanceTile>(std::move(now)));
    });
    return slots;
}

// All squares that lie in the region, so that rules plant nothing there.
void markSquares(NewTiles& tiles, const PlantRegion& region)
{
    const glm::ivec2 low{glm::floor(region.bounds().low)}, high{glm::floor(region.bounds().high)};
    for (int z = low.y; z <= high.y; ++z)
        for (int x = low.x; x <= high.x; ++x) {
            const auto corner = [&](int dx, int dz) { return region.contains(glm::dvec2{x + dx, z + dz}); };
            if (!corner(0, 0) || !corner(1, 0) || !corner(0, 1) || !corner(1, 1)) continue; // what stands in the rest of it is not meant
            const glm::ivec2 tile{x >> 6, z >> 6}, square{x & 63, z & 63};
            markErased(tiles.at(tile), square);
        }
}
static_assert(io::kInstanceTile == 64);

// Works out blocks of tiles on all processors; one(part, slots). False when it was stopped.
bool inBlocks(const PlaneRect& bounds, bool beside, const io::Progress& progress, InstanceSlots& slots, auto&& one)
{
    if (bounds.low.x >= bounds.high.x || bounds.low.y >= bounds.high.y) return true;
    const TileRect tiles = tilesOf(bounds);
    const glm::ivec2 blocks = (tiles.high - tiles.low) / kBlock + 1;
    const int count = blocks.x * blocks.y;
    std::vector<InstanceSlots> made(static_cast<std::size_t>(count));
    std::atomic<int> done = 0;
    std::atomic<bool> stopped = false;
    std::mutex reporting;
    const auto work = [&](int from, int to) {
        for (int i = from; i < to && !stopped; ++i) {
            const glm::ivec2 low = tiles.low + kBlock * glm::ivec2{i % blocks.x, i / blocks.x};
            const PlaneRect block = rectOf({low, glm::min(low + kBlock - 1, tiles.high)});
            one(block, made[std::size_t(i)]);
            ++done;
            const std::lock_guard lock{reporting};
            if (!io::report(progress, float(done) / float(count), "planting")) stopped = true;
        }
    };
    if (beside) io::inParallel(count, 4, work);
    else work(0, count);
    if (stopped) return false;
    for (InstanceSlots& some : made)
        std::ranges::move(some, std::back_inserter(slots));
    return true;
}

void put(NewTiles& tiles, const Plant& plant, std::uint8_t flags)
{
    const io::PlacedInstance placed = io::instanceAt(plant.transform, int(plant.kind), flags);
    tiles.at(placed.tile).instances.push_back(placed.instance);
}

PlaneRect common(const PlaneRect& a, const PlaneRect& b)
{
    return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

} // namespace

LayerTiles layerTiles(const io::Scene& scene, const io::ScatterLayer& layer)
{
    return {.layer = layer.id, .tiles = scene.instances(layer.id), .rule = layer.rule, .species = {}};
}

InstanceSlots planted(const LayerTiles& layer, const Planting& planting, const PlantRegion& region, const io::Progress& progress)
{
    InstanceSlots slots;
    const auto wanted = [&](const glm::dvec2& at) { return region.contains(at); };
    const bool whole = inBlocks(common(region.bounds(), planting.reach()), planting.beside(), progress, slots, [&](const PlaneRect& block, InstanceSlots& own) {
        const PlaneRect part = common(block, region.bounds());
        const Standing standing = standingIn(layer, planting.pattern(), part, false);
        NewTiles tiles{layer.tiles};
        for (const Plant& plant : planting.plants(part, wanted, &standing))
            put(tiles, plant, io::kPaintedInstance);
        tiles.moveTo(own, layer.layer);
    });
    return whole ? slots : InstanceSlots{};
}

InstanceSlots erased(const LayerTiles& layer, const PlantRegion& region)
{
    InstanceSlots slots = edited(layer, region, [](const glm::ivec2&, const io::Instance&) { return false; });
    if (!layer.rule || !layer.species.empty() || region.bounds().high.x - region.bounds().low.x > kMostMarked) return slots;
    io::InstanceTiles now = layer.tiles; // nothing grows again where all was erased
    applySlots(now, slots);
    NewTiles tiles{now};
    markSquares(tiles, region);
    InstanceSlots marked;
    tiles.moveTo(marked, layer.layer);
    std::erase_if(slots, [&](const SwapInstances::Slot& slot) {
        return std::ranges::any_of(marked, [&](const SwapInstances::Slot& other) { return other.first == slot.first; });
    });
    std::ranges::move(marked, std::back_inserter(slots));
    return slots;
}

InstanceSlots thinned(const LayerTiles& layer, const PlantRegion& region, double share)
{
    return edited(layer, region, [&](const glm::ivec2& tile, const io::Instance& instance) {
        return double(io::unitOf(io::hash(instance.x, instance.z, io::hash(tile.x, tile.y, 0x7415u)))) < share;
    });
}

InstanceSlots replaced(const LayerTiles& layer, const PlantRules& rules, const PlantRegion& region, std::uint8_t from, std::uint8_t to)
{
    if (from >= rules.kinds.size() || to >= rules.kinds.size() || from == to) return {};
    const PlantKind &old = rules.kinds[from], &other = rules.kinds[to];
    const float larger = (other.scale.x + other.scale.y) / std::max(old.scale.x + old.scale.y, 1e-6f);
    return edited(layer, region, [&](const glm::ivec2& place, io::Instance& instance) {
        if (instance.species != from) return true;
        io::Transform transform = transformOf(place, instance);
        transform.position.y += double(old.foot * transform.scale.y + old.sink);
        transform.scale *= larger;
        transform.position.y -= double(other.foot * transform.scale.y + other.sink);
        const io::PlacedInstance now = io::instanceAt(transform, to, std::uint8_t(instance.flags | io::kPaintedInstance));
        if (now.tile == place) instance = now.instance;
        return true;
    });
}

std::optional<InstanceSlots> evaluated(const LayerTiles& layer, const Planting& planting, const PlaneRect& bounds, const io::Progress& progress)
{
    InstanceSlots slots;
    PlaneRect reach = planting.reach();
    for (const auto& [place, tile] : layer.tiles) { // what grew where there is no ground any more goes
        const PlaneRect rect = rectOf({place, place});
        reach = {glm::min(reach.low, rect.low), glm::max(reach.high, rect.high - 1.0)};
    }
    const bool whole = inBlocks(common(bounds, reach), planting.beside(), progress, slots, [&](const PlaneRect& block, InstanceSlots& own) {
        const Standing standing = standingIn(layer, planting.pattern(), block, true);
        NewTiles tiles{layer.tiles};
        eachTile(layer.tiles, tilesOf({block.low, block.high - 1.0}), [&](const glm::ivec2& place, const io::InstanceTile&) {
            std::erase_if(tiles.at(place).instances, [](const io::Instance& instance) { return !(instance.flags & io::kPaintedInstance); });
        });
        for (const Plant& plant : planting.plants(block, {}, &standing)) {
            const io::PlacedInstance placed = io::instanceAt(plant.transform, int(plant.kind));
            io::InstanceTile& tile = tiles.at(placed.tile);
            if (!isErased(tile, placed.instance)) tile.instances.push_back(placed.instance);
        }
        tiles.moveTo(own, layer.layer);
    });
    if (!whole) return std::nullopt;
    return slots;
}

void applySlots(io::InstanceTiles& tiles, const InstanceSlots& later)
{
    for (const auto& [where, tile] : later) {
        if (tile) tiles[where.tile] = tile;
        else tiles.erase(where.tile);
    }
}

std::size_t countIn(const io::InstanceTiles& tiles, const PlantRegion& region)
{
    return counted(tiles, region, [](const io::Instance&) { return true; });
}

std::size_t countIn(const LayerTiles& layer, const PlantRegion& region)
{
    return counted(layer.tiles, region, [&](const io::Instance& instance) { return layer.means(instance); });
}

} // namespace editor
