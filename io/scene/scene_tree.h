// SceneTree: where things are. Boxes with small keys in a quadtree over x and z whose tall crowded nodes split in
// height too; for culling, rays, box selection and neighbours. Changes cost the depth of the tree.
#pragma once

#include "io/base/contract.h"
#include "io/scene/bounds.h"
#include "io/scene/handle_table.h"
#include "io/scene/tree_geometry.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace io {

template <class Value>
concept TreeKey = sizeof(Value) == 4 && (std::integral<Value> || std::is_enum_v<Value>);

template <TreeKey Value> class SceneTree {
public:
    // Boxes are kept as floats of world coordinates, rounded outwards: wider than they were by at most 8 mm on each
    // side at 100 km from the origin, 0.1 mm at 1 km.
    struct Item {
        Box box;
        Value value;
    };

    // A node as traversals show it.
    struct Node {
        Box box;                     // fits all that is in it and below
        std::span<const Item> items; // its own: too large for its children, or all of them in a leaf
        std::uint32_t below = 0;     // items in it and below
        int depth = 0;               // 0: the root
        bool leaf = true;
        int children = 0; // 2 above one another, 4 beside one another, 8 both
    };

    static constexpr double kReach = 0x1p40;      // m; boxes beyond are refused
    static constexpr double kLeastSide = 0x1p-4;  // m; cells do not get smaller
    static constexpr std::uint32_t kCrowded = 64; // a leaf with more splits
    static constexpr std::uint32_t kThin = 24;    // a node with no more below it becomes a leaf

    SceneTree() = default;
    SceneTree(SceneTree&&) = default;
    SceneTree& operator=(SceneTree&&) = default;

    // Each answers false and changes nothing where the box is empty, infinite or not a number (counted in refused()),
    // where insert() knows the value already, or where move() and remove() do not. set() inserts or moves.
    bool insert(Value value, const WorldBox& box);
    bool move(Value value, const WorldBox& box);
    bool set(Value value, const WorldBox& box) { return contains(value) ? move(value, box) : insert(value, box); }
    bool remove(Value value);

    // All at once, in place of what was there: many times faster than one by one. `boxOf(value)` is a WorldBox.
    template <class BoxOf> void build(std::span<const Value> values, BoxOf&& boxOf);
    void clear() { *this = SceneTree{}; }

    bool contains(Value value) const { return placeOf(value).node != kNone; }
    Box box(Value value) const; // as kept; empty for what is not in the tree
    Box bounds() const { return m_nodes.empty() ? Box{} : m_nodes[0].box; }
    std::size_t size() const { return m_handles.size(); }
    std::size_t refused() const { return m_refused; }
    std::size_t bytes() const;
    std::string validate() const; // what is wrong inside; empty when all is well

    // Traversals. The tree must not change meanwhile. The order depends on what was done to the tree, on nothing else.

    // `visit(node)` answers whether to go on below it. With `rank`, children come in rising order of rank(node).
    template <class Visit, class Rank = std::nullptr_t> void preOrder(Visit&& visit, Rank&& rank = nullptr) const;
    // The same level for level, the root first; the children of each node in rising order of rank(node).
    template <class Visit, class Rank = std::nullptr_t> void byLevel(Visit&& visit, Rank&& rank = nullptr) const;

    // Items whose box the ray enters within `reach` (m), in the order of where it does. `visit(item, entry)` answers
    // how far the ray still goes.
    template <class Visit> void ray(const Ray& ray, double reach, Visit&& visit) const;
    // Items by how far their box is from a point, nearest first. `visit(item, distance)` answers how far to go on.
    template <class Visit> void nearest(const glm::dvec3& point, double reach, Visit&& visit) const;
    // `visit(item)` for each item whose box touches `box`.
    template <class Visit> void touching(const WorldBox& box, Visit&& visit) const;
    // Inside is where dot(n, p) + d >= 0 for each plane (n, d), up to 32 of them. `visit(items, whole)` for each node
    // that may be inside: where `whole`, all its items are, else each is to be tested.
    template <class Visit> void frustum(std::span<const glm::dvec4> planes, Visit&& visit) const;

private:
    static constexpr std::uint32_t kNone = HandleTable::kNowhere;
    // Beyond this many own items a box is not fitted anew at each removal, but after a share of them.
    static constexpr std::uint32_t kFitted = 64;
    enum Split : std::uint8_t { kLeaf = 0, kFloors = 1, kQuads = 2, kOctants = 3 };

    // Items of one node, in one piece of memory.
    struct Run {
        std::unique_ptr<Item[]> items;
        std::uint32_t count = 0;
        std::uint32_t capacity = 0;

        std::span<Item> all() const { return {items.get(), count}; }
        void reserve(std::uint32_t wanted);
        void add(const Item& item);
    };
    struct Cell {
        Box box;              // around everything in it and below
        Box own;              // around its own items
        glm::dvec3 centre{0}; // m; what is in it has its middle in the cell and is no larger than it
        float side = 0;       // m, of x and z; a power of two as the height is
        float height = 0;     // m
        std::uint32_t parent = kNone;
        std::uint32_t firstChild = kNone;
        Run run;
        std::uint32_t below = 0;
        std::uint32_t splitAt = kCrowded; // as a leaf: tries to split with more items than this
        std::uint32_t loosened = 0;       // removals since `own` was fitted
        Split split = kLeaf;
    };
    using Place = HandleTable::Place;
    struct Step { // of a traversal by distance
        double at;
        std::uint32_t node, item; // item kNone: the node itself
        auto key() const { return std::tuple{at, node, item}; }
    };

    static std::uint32_t key(Value value) { return static_cast<std::uint32_t>(value); }
    static std::uint32_t childCount(Split split) { return split == kLeaf ? 0 : 1u << split; }
    static bool goesDown(const Cell& cell, const Box& box);
    static std::uint32_t childFor(const Cell& cell, const Box& box);
    static Split waysToSplit(const Cell& cell, std::span<const Item> items);
    static bool inside(const Cell& cell, const Box& box);

    Place placeOf(Value value) const { return m_handles.find(key(value)); }
    bool accept(const WorldBox& box);
    void addItem(const Item& item);
    void takeOut(Place place);
    void startAt(const Box& box);
    void growTo(const Box& box);
    void grow(const glm::dvec3& towards, Split split);
    void shrink();
    std::uint32_t target(const Box& box) const;
    void settle(std::uint32_t node, std::span<Item> items);
    void keep(std::uint32_t node, std::span<const Item> items);
    std::uint32_t makeChildren(std::uint32_t node, Split split);
    std::uint32_t takeBlock(std::uint32_t count);
    void freeBelow(std::uint32_t node);
    void gather(std::uint32_t node, std::vector<Item>& items) const;
    void collapseThin(std::uint32_t node);
    void repoint(std::uint32_t node);
    void loosen(Cell& cell, const Box& gone);
    void fitUpwards(std::uint32_t node);
    Box fitted(const Cell& cell) const;
    Node shown(std::uint32_t node, int depth) const;
    std::string faultIn(std::uint32_t node) const;

    template <class Visit, class Rank> void descend(std::uint32_t node, int depth, Visit& visit, Rank& rank) const;
    template <class Rank>
    std::span<const std::uint32_t> ranked(const Cell& cell, int depth, Rank& rank,
                                          std::array<std::uint32_t, 8>& order) const;
    template <class Measure, class Visit> void byDistance(double reach, const Measure& measure, Visit& visit) const;
    template <class Visit> void touchingBelow(std::uint32_t node, const WorldBox& box, Visit& visit) const;
    template <class Visit>
    void frustumBelow(std::uint32_t node, std::span<const glm::dvec4> planes, std::uint32_t undecided,
                      Visit& visit) const;

    std::vector<Cell> m_nodes;                              // the root is the first
    std::array<std::vector<std::uint32_t>, 4> m_freeBlocks; // of 2, 4 and 8 nodes, by Split
    HandleTable m_handles;
    std::size_t m_refused = 0;
};

} // namespace io

#include "io/scene/scene_tree_change.h"
#include "io/scene/scene_tree_walk.h"
