#include "editor/ray_tiles.h"

#include "editor/ray_scene.h"

#include <algorithm>

namespace editor {
namespace {

constexpr std::size_t kThinTile = 64;    // a tile of fewer is dissolved
constexpr std::size_t kShareOfTile = 32; // a group founds a tile if it has as many for each tile that it overlaps

io::WorldBox around(std::span<const std::uint32_t> places, std::span<const RayInstance> instances)
{
    io::WorldBox box;
    for (const std::uint32_t place : places)
        box.add(instances[place].bounds);
    return box;
}

int longest(const glm::vec3& v)
{
    return v.x >= v.y && v.x >= v.z ? 0 : v.y >= v.z ? 1 : 2;
}

// What partition() sorts by, side by side in memory: a million instances themselves lie too far apart for that.
struct Placed {
    glm::vec3 middle{0};
    std::uint32_t place = 0;
};

// Halves by the median along the longer side, until each is no more than a tile.
template <class Visit> void partition(std::span<Placed> placed, Visit& visit)
{
    if (placed.size() <= RayScene::kTile) return visit(placed);
    io::Box middles;
    for (const Placed& one : placed)
        middles.add(one.middle);
    const int axis = longest(middles.size());
    const auto half = placed.begin() + std::ptrdiff_t(placed.size() / 2);
    std::nth_element(placed.begin(), half, placed.end(), [&](const Placed& a, const Placed& b) {
        return a.middle[axis] != b.middle[axis] ? a.middle[axis] < b.middle[axis] : a.place < b.place;
    });
    partition({placed.begin(), half}, visit);
    partition({half, placed.end()}, visit);
}

} // namespace

void RayTiles::clear()
{
    instances.clear();
    m_tiles.clear();
    m_freeTiles.clear();
    m_thin.clear();
    m_full.clear();
    m_built.clear();
    m_tree.clear();
    m_boxes.clear();
}

void RayTiles::touchAll()
{
    for (const auto& tile : m_tiles)
        if (tile) tile->touch();
}

void RayTiles::add(std::uint32_t place)
{
    if (m_tiles.empty()) m_tiles.push_back(std::make_unique<RayTile>());
    put(place, kRecentTile);
}

void RayTiles::put(std::uint32_t place, std::uint32_t number)
{
    RayTile& to = tile(number);
    instances[place].tile = number;
    instances[place].slot = std::uint32_t(to.members.size());
    to.members.push_back(place);
    if (number == kRecentTile) return to.touch();
    to.came(place);
}

void RayTiles::takeOut(std::uint32_t place)
{
    RayInstance& instance = instances[place];
    ++instance.version;
    if (instance.tile == kNoTile) return;
    const std::uint32_t number = std::exchange(instance.tile, kNoTile);
    RayTile& from = tile(number);
    const std::uint32_t last = from.members.back();
    from.members[instance.slot] = last;
    instances[last].slot = instance.slot;
    from.members.pop_back();
    from.went(place);
    if (number == kRecentTile) return;
    if (from.members.empty())
        drop(number);
    else if (from.members.size() == kThinTile - 1)
        m_thin.push_back(number);
}

void RayTiles::drop(std::uint32_t number)
{
    m_tree.remove(number);
    m_boxes.remove(number);
    m_tiles[number].reset();
    m_freeTiles.push_back(number);
}

void RayTiles::makeTile(Places places)
{
    std::uint32_t number = std::uint32_t(m_tiles.size());
    if (m_freeTiles.empty()) {
        m_tiles.emplace_back();
    } else {
        number = m_freeTiles.back();
        m_freeTiles.pop_back();
    }
    m_tiles[number] = std::make_unique<RayTile>();
    m_tiles[number]->members.reserve(places.size());
    for (const std::uint32_t place : places)
        put(place, number);
    m_tiles[number]->widen(around(places, instances));
    EXPECTS(m_tree.insert(number, m_tiles[number]->box()));
    m_boxes.set(number, m_tiles[number]->box());
}

void RayTiles::joinNearest(std::uint32_t place)
{
    std::uint32_t nearest = kNoTile;
    m_tree.nearest(instances[place].bounds.centre(), 1e300, [&](const auto& item, double) {
        nearest = item.value;
        return -1;
    });
    if (nearest == kNoTile) return makeTile({&place, 1});
    put(place, nearest);
    RayTile& to = tile(nearest);
    if (to.members.size() == RayScene::kTile * 3 / 2) m_full.push_back(nearest);
    to.widen(instances[place].bounds);
    moved(nearest);
}

void RayTiles::moved(std::uint32_t number)
{
    m_tree.move(number, tile(number).box());
    m_boxes.set(number, tile(number).box());
}

// Groups of them that lie densely become tiles of their own, the others join what is there.
void RayTiles::found(Places places, bool always)
{
    std::vector<Placed> placed;
    placed.reserve(places.size());
    for (const std::uint32_t place : places)
        placed.push_back({glm::vec3{instances[place].bounds.centre()}, place});
    std::vector<std::uint32_t> group;
    const auto settleGroup = [&](std::span<const Placed> together) {
        group.clear();
        for (const Placed& one : together)
            group.push_back(one.place);
        std::size_t overlapped = 0;
        if (!always) m_tree.touching(around(group, instances), [&](const auto&) { ++overlapped; });
        if (group.size() >= overlapped * kShareOfTile) return makeTile(group);
        for (const std::uint32_t place : group)
            joinNearest(place);
    };
    partition(std::span{placed}, settleGroup);
}

// Everything where it belongs, once the recent ones are many.
void RayTiles::settle()
{
    if (m_tiles.empty()) return;
    tighten();
    for (const std::uint32_t number : std::exchange(m_thin, {})) {
        if (!m_tiles[number] || tile(number).members.size() >= kThinTile) continue;
        for (const std::uint32_t place : tile(number).members)
            put(place, kRecentTile);
        drop(number);
    }
    if (tile(kRecentTile).members.size() > RayScene::kRecent) {
        std::vector<std::uint32_t> places = std::exchange(tile(kRecentTile).members, {});
        tile(kRecentTile).touch();
        found(places, false);
    }
    for (const std::uint32_t number : std::exchange(m_full, {})) {
        if (!m_tiles[number] || tile(number).members.size() <= RayScene::kTile) continue;
        std::vector<std::uint32_t> places = std::move(tile(number).members);
        drop(number);
        found(places, true);
    }
}

void RayTiles::build(std::uint32_t number)
{
    const bool anew = tile(number).build(m_device, instances, m_meshOf, number == kRecentTile);
    if (anew && number != kRecentTile) m_built.push_back(number);
}

// A tile that was built again may have become smaller.
void RayTiles::tighten()
{
    for (const std::uint32_t number : m_built)
        if (m_tiles[number] && m_tree.contains(number)) moved(number);
    m_built.clear();
}

void RayTiles::prepare()
{
    settle();
    for (std::uint32_t number = 0; number < m_tiles.size(); ++number)
        if (m_tiles[number] && tile(number).stale()) build(number);
    tighten();
}

RayTreeHit RayTiles::hit(const RayQuery& query, double reach)
{
    settle();
    RayTreeHit best{.distance = reach};
    if (m_tiles.empty()) return best;
    const auto enter = [&](std::uint32_t number, double entry) {
        if (tile(number).stale()) build(number);
        tile(number).hit(query, instances, entry, best);
        return best.distance;
    };
    if (!tile(kRecentTile).members.empty()) {
        if (tile(kRecentTile).stale()) build(kRecentTile);
        const double entry = io::SlabTest{query.ray}.entry(io::roundedOutwards(tile(kRecentTile).box()));
        if (entry <= reach) enter(kRecentTile, entry);
    }
    m_boxes.ray(query.ray, best.distance, enter);
    return best;
}

} // namespace editor
