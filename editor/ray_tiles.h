// RayTiles: which instance lies in which tile, and the tiles along a ray. Tiles are made of instances that are near
// each other; later ones join the nearest tile, or found one where many come at once.
#pragma once

#include "editor/ray_tile.h"
#include "editor/tile_boxes.h"
#include "io/scene/scene_tree.h"

#include <memory>
#include <span>
#include <vector>

namespace editor {

class RayTiles {
public:
    RayTiles(RTCDevice device, RayTree::MeshOf meshOf) : m_device{device}, m_meshOf{std::move(meshOf)} {}

    std::vector<RayInstance> instances; // by place

    void add(std::uint32_t place);
    void takeOut(std::uint32_t place); // it moved or is gone: what is built of it no longer counts
    void clear();
    void touchAll(); // other meshes stand for the templates

    RayTreeHit hit(const RayQuery& query, double reach);
    void prepare(); // builds every tile
    template <class Visit> void forEachInside(std::span<const glm::dvec4> planes, Visit&& visit);

private:
    static constexpr std::uint32_t kRecentTile = 0; // always there, not in the tree

    using Places = std::span<const std::uint32_t>;
    RayTile& tile(std::uint32_t number) { return *m_tiles[number]; }
    void settle();
    void found(Places places, bool always);
    void makeTile(Places places);
    void joinNearest(std::uint32_t place);
    void put(std::uint32_t place, std::uint32_t number);
    void drop(std::uint32_t number);
    void build(std::uint32_t number);
    void moved(std::uint32_t number); // its box did
    void tighten();

    RTCDevice m_device;
    RayTree::MeshOf m_meshOf;
    std::vector<std::unique_ptr<RayTile>> m_tiles;
    std::vector<std::uint32_t> m_freeTiles;
    std::vector<std::uint32_t> m_thin, m_full, m_built; // tiles to look after before the next ray
    io::SceneTree<std::uint32_t> m_tree;                // of tiles
    TileBoxes m_boxes;                                  // of the same, for rays
};

template <class Visit> void RayTiles::forEachInside(std::span<const glm::dvec4> planes, Visit&& visit)
{
    settle();
    for (const std::uint32_t place : tile(kRecentTile).members)
        visit(std::as_const(instances[place]));
    m_tree.frustum(planes, [&](std::span<const io::SceneTree<std::uint32_t>::Item> items, bool whole) {
        for (const auto& item : items) {
            const auto outside = [&](const glm::dvec4& plane) { return sideOf(item.box, plane) == io::Side::Outside; };
            if (!whole && std::ranges::any_of(planes, outside)) continue;
            for (const std::uint32_t place : tile(item.value).members)
                visit(std::as_const(instances[place]));
        }
    });
}

} // namespace editor
