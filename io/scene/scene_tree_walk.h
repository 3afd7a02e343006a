// SceneTree's traversals. Included by io/scene/scene_tree.h alone.
#pragma once

namespace io {

template <TreeKey Value> typename SceneTree<Value>::Node SceneTree<Value>::shown(std::uint32_t node, int depth) const
{
    const Cell& cell = m_nodes[node];
    return {.box = cell.box,
            .items = cell.run.all(),
            .below = cell.below,
            .depth = depth,
            .leaf = cell.split == kLeaf,
            .children = int(childCount(cell.split))};
}

// The children that hold something, in the order in which they are to be seen.
template <TreeKey Value>
template <class Rank>
std::span<const std::uint32_t> SceneTree<Value>::ranked(const Cell& cell, int depth, Rank& rank,
                                                        std::array<std::uint32_t, 8>& order) const
{
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < childCount(cell.split); ++i)
        if (m_nodes[cell.firstChild + i].below > 0) order[count++] = cell.firstChild + i;
    if constexpr (!std::is_same_v<std::remove_cvref_t<Rank>, std::nullptr_t>) {
        using Key = decltype(rank(std::declval<const Node&>()));
        std::array<std::pair<Key, std::uint32_t>, 8> keys{};
        for (std::size_t i = 0; i < count; ++i)
            keys[i] = {rank(shown(order[i], depth + 1)), order[i]};
        std::sort(keys.begin(), keys.begin() + std::ptrdiff_t(count));
        for (std::size_t i = 0; i < count; ++i)
            order[i] = keys[i].second;
    }
    return {order.data(), count};
}

template <TreeKey Value>
template <class Visit, class Rank>
void SceneTree<Value>::descend(std::uint32_t node, int depth, Visit& visit, Rank& rank) const
{
    if (!visit(shown(node, depth))) return;
    std::array<std::uint32_t, 8> order;
    for (const std::uint32_t child : ranked(m_nodes[node], depth, rank, order))
        descend(child, depth + 1, visit, rank);
}

template <TreeKey Value>
template <class Visit, class Rank>
void SceneTree<Value>::preOrder(Visit&& visit, Rank&& rank) const
{
    if (size() > 0) descend(0, 0, visit, rank);
}

template <TreeKey Value>
template <class Visit, class Rank>
void SceneTree<Value>::byLevel(Visit&& visit, Rank&& rank) const
{
    std::vector<std::uint32_t> level, next;
    if (size() > 0) level.push_back(0);
    for (int depth = 0; !level.empty(); ++depth) {
        next.clear();
        for (const std::uint32_t node : level) {
            if (!visit(shown(node, depth))) continue;
            std::array<std::uint32_t, 8> order;
            const auto children = ranked(m_nodes[node], depth, rank, order);
            next.insert(next.end(), children.begin(), children.end());
        }
        level.swap(next);
    }
}

// Best first (Hjaltason and Samet 1999): a heap of nodes and items by their distance.
template <TreeKey Value>
template <class Measure, class Visit>
void SceneTree<Value>::byDistance(double reach, const Measure& measure, Visit& visit) const
{
    if (size() == 0) return;
    const auto later = [](const Step& a, const Step& b) { return a.key() > b.key(); };
    std::vector<Step> heap;
    heap.reserve(40); // small enough for malloc's quick lists
    const auto offer = [&](const Box& box, std::uint32_t node, std::uint32_t item) {
        const double at = measure(box);
        if (!(at <= reach) || at == SlabTest::kMiss) return;
        heap.push_back({at, node, item});
        std::push_heap(heap.begin(), heap.end(), later);
    };
    offer(m_nodes[0].box, 0, kNone);
    while (!heap.empty() && heap.front().at <= reach) {
        const Step step = heap.front();
        std::pop_heap(heap.begin(), heap.end(), later);
        heap.pop_back();
        const Cell& cell = m_nodes[step.node];
        if (step.item != kNone) {
            reach = std::min(reach, double(visit(std::as_const(cell.run.items[step.item]), step.at)));
            continue;
        }
        for (std::uint32_t i = 0; i < cell.run.count; ++i)
            offer(cell.run.items[i].box, step.node, i);
        for (std::uint32_t i = 0; i < childCount(cell.split); ++i)
            if (m_nodes[cell.firstChild + i].below > 0)
                offer(m_nodes[cell.firstChild + i].box, cell.firstChild + i, kNone);
    }
}

template <TreeKey Value>
template <class Visit>
void SceneTree<Value>::ray(const Ray& ray, double reach, Visit&& visit) const
{
    const SlabTest slabs{ray};
    byDistance(
        reach, [&](const Box& box) { return slabs.entry(box); }, visit);
}

template <TreeKey Value>
template <class Visit>
void SceneTree<Value>::nearest(const glm::dvec3& point, double reach, Visit&& visit) const
{
    byDistance(
        reach, [&](const Box& box) { return distance(box, point); }, visit);
}

template <TreeKey Value>
template <class Visit>
void SceneTree<Value>::touchingBelow(std::uint32_t node, const WorldBox& box, Visit& visit) const
{
    const Cell& cell = m_nodes[node];
    for (const Item& item : cell.run.all())
        if (touches(item.box, box)) visit(item);
    for (std::uint32_t i = 0; i < childCount(cell.split); ++i) {
        const Cell& child = m_nodes[cell.firstChild + i];
        if (child.below > 0 && touches(child.box, box)) touchingBelow(cell.firstChild + i, box, visit);
    }
}

template <TreeKey Value>
template <class Visit>
void SceneTree<Value>::touching(const WorldBox& box, Visit&& visit) const
{
    if (size() > 0 && touches(m_nodes[0].box, box)) touchingBelow(0, box, visit);
}

// `undecided`: a bit for each plane that the node above lies across; the others it lies inside of.
template <TreeKey Value>
template <class Visit>
void SceneTree<Value>::frustumBelow(std::uint32_t node, std::span<const glm::dvec4> planes, std::uint32_t undecided,
                                    Visit& visit) const
{
    const Cell& cell = m_nodes[node];
    if (cell.below == 0) return;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        if (!(undecided >> i & 1)) continue;
        const Side side = sideOf(cell.box, planes[i]);
        if (side == Side::Outside) return;
        if (side == Side::Inside) undecided &= ~(1u << i);
    }
    if (cell.run.count > 0) visit(std::span<const Item>{cell.run.all()}, undecided == 0);
    for (std::uint32_t i = 0; i < childCount(cell.split); ++i)
        frustumBelow(cell.firstChild + i, planes, undecided, visit);
}

template <TreeKey Value>
template <class Visit>
void SceneTree<Value>::frustum(std::span<const glm::dvec4> planes, Visit&& visit) const
{
    EXPECTS(planes.size() <= 32);
    if (size() == 0) return;
    frustumBelow(0, planes, std::uint32_t((std::uint64_t{1} << planes.size()) - 1), visit);
}

} // namespace io
