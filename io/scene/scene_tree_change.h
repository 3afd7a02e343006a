// SceneTree's changes: how it grows, splits, merges and keeps its boxes fitted. Included by io/scene/scene_tree.h
// alone.
#pragma once

namespace io {

template <TreeKey Value> void SceneTree<Value>::Run::reserve(std::uint32_t wanted)
{
    if (wanted <= capacity) return;
    const std::uint32_t larger = (std::max(wanted, capacity + capacity / 4) + 3) / 4 * 4;
    std::unique_ptr<Item[]> moved{new Item[larger]};
    std::copy_n(items.get(), count, moved.get());
    items = std::move(moved);
    capacity = larger;
}

template <TreeKey Value> void SceneTree<Value>::Run::add(const Item& item)
{
    reserve(count + 1);
    items[count++] = item;
}

template <TreeKey Value> bool SceneTree<Value>::accept(const WorldBox& box)
{
    bool good = true;
    for (int axis = 0; axis < 3; ++axis)
        good = good && std::abs(box.min[axis]) <= kReach && std::abs(box.max[axis]) <= kReach &&
               box.min[axis] <= box.max[axis];
    m_refused += !good;
    return good;
}

// Where a box counts as being: exact in doubles, so the same at each look.
inline glm::dvec3 middleOf(const Box& box)
{
    return (glm::dvec3{box.min} + glm::dvec3{box.max}) * 0.5;
}
inline double widthOf(const Box& box)
{
    return std::max(double(box.max.x) - double(box.min.x), double(box.max.z) - double(box.min.z));
}
inline double heightOf(const Box& box)
{
    return double(box.max.y) - double(box.min.y);
}

// Whether a box is no larger than the children.
template <TreeKey Value> bool SceneTree<Value>::goesDown(const Cell& cell, const Box& box)
{
    return widthOf(box) <= double(cell.side) / (cell.split & kQuads ? 2 : 1) &&
           heightOf(box) <= double(cell.height) / (cell.split & kFloors ? 2 : 1);
}

template <TreeKey Value> std::uint32_t SceneTree<Value>::childFor(const Cell& cell, const Box& box)
{
    const glm::dvec3 middle = middleOf(box);
    std::uint32_t child = 0;
    if (cell.split & kQuads) child = std::uint32_t(middle.x >= cell.centre.x) + 2 * (middle.z >= cell.centre.z);
    if (cell.split & kFloors) child = 2 * child + (middle.y >= cell.centre.y);
    return child;
}

template <TreeKey Value> bool SceneTree<Value>::inside(const Cell& cell, const Box& box)
{
    const glm::dvec3 half = glm::dvec3{cell.side, cell.height, cell.side} * 0.5;
    const glm::dvec3 from = cell.centre - half, to = cell.centre + half, middle = middleOf(box);
    return middle.x >= from.x && middle.y >= from.y && middle.z >= from.z && middle.x < to.x && middle.y < to.y &&
           middle.z < to.z && widthOf(box) <= double(cell.side) && heightOf(box) <= double(cell.height);
}

// The node that an item of this box belongs to.
template <TreeKey Value> std::uint32_t SceneTree<Value>::target(const Box& box) const
{
    std::uint32_t node = 0;
    while (m_nodes[node].split != kLeaf && goesDown(m_nodes[node], box))
        node = m_nodes[node].firstChild + childFor(m_nodes[node], box);
    return node;
}

template <TreeKey Value> void SceneTree<Value>::startAt(const Box& box)
{
    constexpr double kSide = 64; // m
    m_nodes.clear();
    m_nodes.emplace_back();
    for (auto& blocks : m_freeBlocks)
        blocks.clear();
    m_nodes[0].side = m_nodes[0].height = float(kSide);
    m_nodes[0].centre = glm::round(middleOf(box) / kSide) * kSide; // every cell's centre is exact in a double
}

template <TreeKey Value> void SceneTree<Value>::growTo(const Box& box)
{
    while (!inside(m_nodes[0], box)) {
        const Cell& root = m_nodes[0];
        const glm::dvec3 middle = middleOf(box);
        const double off = std::max(std::abs(middle.x - root.centre.x), std::abs(middle.z - root.centre.z));
        const bool wider = 2 * off >= double(root.side) || widthOf(box) > double(root.side);
        grow(middle, wider ? kQuads : kFloors);
    }
}

// Doubles the root's side or height towards a point. A leaf just gets larger; else the root becomes a child.
template <TreeKey Value> void SceneTree<Value>::grow(const glm::dvec3& towards, Split split)
{
    const Cell& old = m_nodes[0];
    Cell larger;
    larger.side = old.side * (split == kQuads ? 2 : 1);
    larger.height = old.height * (split == kFloors ? 2 : 1);
    glm::dvec3 shift = glm::dvec3{old.side, old.height, old.side} * 0.5;
    for (int axis = 0; axis < 3; ++axis)
        shift[axis] *= (axis == 1) != (split == kFloors) ? 0 : towards[axis] >= old.centre[axis] ? 1 : -1;
    larger.centre = old.centre + shift;
    if (old.split == kLeaf) {
        m_nodes[0].side = larger.side;
        m_nodes[0].height = larger.height;
        m_nodes[0].centre = larger.centre;
        return;
    }
    larger.below = old.below;
    larger.box = old.box;
    Cell root = std::exchange(m_nodes[0], std::move(larger));
    const std::uint32_t first = makeChildren(0, split);
    const std::uint32_t at = split == kFloors ? shift.y < 0 : std::uint32_t(shift.x < 0) + 2 * (shift.z < 0);
    root.parent = 0;
    m_nodes[first + at] = std::move(root);
    repoint(first + at);
}

// A root whose content lies in one child gives way to it.
template <TreeKey Value> void SceneTree<Value>::shrink()
{
    while (m_nodes[0].split != kLeaf && m_nodes[0].run.count == 0) {
        const std::uint32_t first = m_nodes[0].firstChild, count = childCount(m_nodes[0].split);
        std::uint32_t only = first;
        while (only < first + count && m_nodes[only].below != m_nodes[0].below)
            ++only;
        if (only == first + count) return;
        const Split split = m_nodes[0].split;
        Cell root = std::move(m_nodes[only]);
        root.parent = kNone;
        m_nodes[0] = std::move(root);
        for (std::uint32_t i = 0; i < count; ++i)
            m_nodes[first + i] = {};
        m_freeBlocks[split].push_back(first);
        repoint(0);
    }
}

// After a node moved to another place in memory: who points to it?
template <TreeKey Value> void SceneTree<Value>::repoint(std::uint32_t node)
{
    const Cell& cell = m_nodes[node];
    for (std::uint32_t i = 0; i < cell.run.count; ++i)
        m_handles.set(key(cell.run.items[i].value), {node, i});
    for (std::uint32_t i = 0; i < childCount(cell.split); ++i)
        m_nodes[cell.firstChild + i].parent = node;
}

template <TreeKey Value> std::uint32_t SceneTree<Value>::takeBlock(std::uint32_t count)
{
    auto& free = m_freeBlocks[count == 2 ? kFloors : count == 4 ? kQuads : kOctants];
    if (!free.empty()) {
        const std::uint32_t first = free.back();
        free.pop_back();
        return first;
    }
    if (m_nodes.size() + count > m_nodes.capacity()) m_nodes.reserve(m_nodes.size() * 5 / 4 + 64);
    m_nodes.resize(m_nodes.size() + count);
    return std::uint32_t(m_nodes.size() - count);
}

template <TreeKey Value> std::uint32_t SceneTree<Value>::makeChildren(std::uint32_t node, Split split)
{
    const std::uint32_t count = childCount(split), first = takeBlock(count);
    Cell& cell = m_nodes[node];
    cell.split = split;
    cell.firstChild = first;
    const bool quads = split & kQuads, floors = split & kFloors;
    for (std::uint32_t i = 0; i < count; ++i) {
        Cell& child = m_nodes[first + i];
        const std::uint32_t quad = floors ? i / 2 : i;
        child.parent = node;
        child.side = cell.side / (quads ? 2 : 1);
        child.height = cell.height / (floors ? 2 : 1);
        child.centre = cell.centre;
        if (quads) child.centre.x += double(cell.side) * (quad & 1 ? 0.25 : -0.25);
        if (quads) child.centre.z += double(cell.side) * (quad & 2 ? 0.25 : -0.25);
        if (floors) child.centre.y += double(cell.height) * (i & 1 ? 0.25 : -0.25);
    }
    return first;
}

// How a leaf is best split: in height where its items spread more in height than sideways. Leaf: in no way that would
// let most of them go down, as when all lie at one place.
template <TreeKey Value>
typename SceneTree<Value>::Split SceneTree<Value>::waysToSplit(const Cell& cell, std::span<const Item> items)
{
    WorldBox middles;
    for (const Item& item : items)
        middles.add(middleOf(item.box));
    const glm::dvec3 spread = middles.size();
    const double sideways = std::max(spread.x, spread.z), up = spread.y;

    std::array<Split, 2> wishes{kQuads, kFloors};
    if (up > sideways) wishes = {kOctants, kFloors};
    if (up > 4 * sideways) wishes = {kFloors, kQuads};
    for (const Split wish : wishes) {
        if (wish & kQuads && (double(cell.side) < 2 * kLeastSide || sideways < kLeastSide)) continue;
        if (wish & kFloors && (double(cell.height) < 2 * kLeastSide || up < kLeastSide)) continue;
        Cell tried;
        tried.side = cell.side;
        tried.height = cell.height;
        tried.split = wish;
        const auto going = std::ranges::count_if(items, [&](const Item& item) { return goesDown(tried, item.box); });
        if (std::size_t(going) * 2 >= items.size()) return wish;
    }
    return kLeaf;
}

template <TreeKey Value> void SceneTree<Value>::keep(std::uint32_t node, std::span<const Item> items)
{
    Cell& cell = m_nodes[node];
    cell.run = {};
    cell.run.reserve(std::uint32_t(items.size()));
    cell.own = {};
    cell.loosened = 0;
    for (const Item& item : items) {
        m_handles.set(key(item.value), {node, cell.run.count});
        cell.own.add(item.box);
        cell.run.items[cell.run.count++] = item;
    }
}

// Puts items into an empty leaf, or below it where they are many. Their order is lost.
template <TreeKey Value> void SceneTree<Value>::settle(std::uint32_t node, std::span<Item> items)
{
    m_nodes[node].below = std::uint32_t(items.size());
    const Split split = items.size() > kCrowded ? waysToSplit(m_nodes[node], items) : kLeaf;
    if (split == kLeaf) {
        keep(node, items);
        m_nodes[node].splitAt = std::max(kCrowded, 2 * std::uint32_t(items.size()) * (items.size() > kCrowded));
        m_nodes[node].box = m_nodes[node].own;
        return;
    }
    const std::uint32_t first = makeChildren(node, split);
    auto rest = std::partition(items.begin(), items.end(),
                               [&](const Item& item) { return !goesDown(m_nodes[node], item.box); });
    keep(node, {items.begin(), rest});
    for (std::uint32_t i = 0; i < childCount(split); ++i) {
        const auto end =
            std::partition(rest, items.end(), [&](const Item& item) { return childFor(m_nodes[node], item.box) == i; });
        if (rest != end) settle(first + i, {rest, end});
        rest = end;
    }
    m_nodes[node].box = fitted(m_nodes[node]);
}

template <TreeKey Value>
template <class BoxOf>
void SceneTree<Value>::build(std::span<const Value> values, BoxOf&& boxOf)
{
    clear();
    std::vector<Item> items;
    items.reserve(values.size());
    for (const Value value : values) {
        const WorldBox box = boxOf(value);
        if (accept(box)) items.push_back({roundedOutwards(box), value});
    }
    if (items.empty()) return;
    m_handles.reserve(items.size());
    startAt(items.front().box);
    for (const Item& item : items)
        growTo(item.box);
    settle(0, items);
    EXPECTS(size() == items.size()); // no value twice
    m_nodes.shrink_to_fit();
}

template <TreeKey Value> void SceneTree<Value>::addItem(const Item& item)
{
    if (size() == 0) startAt(item.box);
    growTo(item.box);
    const std::uint32_t node = target(item.box);
    Cell& cell = m_nodes[node];
    m_handles.set(key(item.value), {node, cell.run.count});
    cell.run.add(item);
    cell.own.add(item.box);
    for (std::uint32_t at = node; at != kNone; at = m_nodes[at].parent) {
        m_nodes[at].box.add(item.box);
        ++m_nodes[at].below;
    }
    if (cell.split != kLeaf || cell.run.count <= cell.splitAt) return;
    const Run run = std::move(cell.run);
    cell.run = {};
    settle(node, run.all());
}

template <TreeKey Value> Box SceneTree<Value>::fitted(const Cell& cell) const
{
    Box box = cell.own;
    for (std::uint32_t i = 0; i < childCount(cell.split); ++i)
        box.add(m_nodes[cell.firstChild + i].box);
    return box;
}

template <TreeKey Value> void SceneTree<Value>::fitUpwards(std::uint32_t node)
{
    for (; node != kNone; node = m_nodes[node].parent) {
        const Box box = fitted(m_nodes[node]);
        if (box == m_nodes[node].box) return;
        m_nodes[node].box = box;
    }
}

// Fits a node's own box after an item left it. With very many items that is put off until a share of them has gone.
template <TreeKey Value> void SceneTree<Value>::loosen(Cell& cell, const Box& gone)
{
    if (cell.run.count > 0 && cell.loosened == 0 && !reachesEdge(cell.own, gone)) return;
    if (cell.run.count > kFitted && ++cell.loosened * kFitted < cell.run.count) return;
    cell.loosened = 0;
    cell.own = {};
    for (const Item& item : cell.run.all())
        cell.own.add(item.box);
}

template <TreeKey Value> void SceneTree<Value>::takeOut(Place place)
{
    Cell& cell = m_nodes[place.node];
    Item& item = cell.run.items[place.item];
    const Item gone = item;
    m_handles.erase(key(gone.value));
    item = cell.run.items[--cell.run.count];
    if (place.item < cell.run.count) m_handles.set(key(item.value), place);
    cell.splitAt = std::max(kCrowded, std::min(cell.splitAt, 2 * cell.run.count));
    for (std::uint32_t at = place.node; at != kNone; at = m_nodes[at].parent)
        --m_nodes[at].below;
    loosen(cell, gone.box);
    fitUpwards(place.node);
    collapseThin(place.node);
    shrink();
}

template <TreeKey Value> void SceneTree<Value>::gather(std::uint32_t node, std::vector<Item>& items) const
{
    const Cell& cell = m_nodes[node];
    items.insert(items.end(), cell.run.all().begin(), cell.run.all().end());
    for (std::uint32_t i = 0; i < childCount(cell.split); ++i)
        gather(cell.firstChild + i, items);
}

template <TreeKey Value> void SceneTree<Value>::freeBelow(std::uint32_t node)
{
    const std::uint32_t first = m_nodes[node].firstChild, count = childCount(m_nodes[node].split);
    if (count == 0) return;
    for (std::uint32_t i = 0; i < count; ++i) {
        freeBelow(first + i);
        m_nodes[first + i] = {};
    }
    m_freeBlocks[m_nodes[node].split].push_back(first);
    m_nodes[node].split = kLeaf;
    m_nodes[node].firstChild = kNone;
}

// The highest node from here up with little below it becomes a leaf.
template <TreeKey Value> void SceneTree<Value>::collapseThin(std::uint32_t node)
{
    std::uint32_t thin = kNone;
    for (; node != kNone && m_nodes[node].below <= kThin; node = m_nodes[node].parent)
        thin = node;
    if (thin == kNone || m_nodes[thin].split == kLeaf) return;
    std::vector<Item> items;
    gather(thin, items);
    freeBelow(thin);
    keep(thin, items);
    m_nodes[thin].splitAt = kCrowded;
    m_nodes[thin].box = m_nodes[thin].own;
    fitUpwards(m_nodes[thin].parent);
}

template <TreeKey Value> bool SceneTree<Value>::insert(Value value, const WorldBox& box)
{
    if (contains(value) || !accept(box)) return false;
    addItem({roundedOutwards(box), value});
    return true;
}

template <TreeKey Value> bool SceneTree<Value>::move(Value value, const WorldBox& box)
{
    const Place place = placeOf(value);
    if (place.node == kNone || !accept(box)) return false;
    const Box now = roundedOutwards(box);
    if (!inside(m_nodes[0], now) || target(now) != place.node) {
        takeOut(place);
        addItem({now, value});
        return true;
    }
    Cell& cell = m_nodes[place.node];
    const Box before = std::exchange(cell.run.items[place.item].box, now);
    loosen(cell, before);
    cell.own.add(now);
    fitUpwards(place.node);
    return true;
}

template <TreeKey Value> bool SceneTree<Value>::remove(Value value)
{
    const Place place = placeOf(value);
    if (place.node == kNone) return false;
    takeOut(place);
    return true;
}

template <TreeKey Value> Box SceneTree<Value>::box(Value value) const
{
    const Place place = placeOf(value);
    return place.node == kNone ? Box{} : m_nodes[place.node].run.items[place.item].box;
}

template <TreeKey Value> std::size_t SceneTree<Value>::bytes() const
{
    std::size_t bytes = sizeof *this + m_nodes.capacity() * sizeof(Cell) + m_handles.bytes();
    for (const Cell& cell : m_nodes)
        bytes += cell.run.capacity * sizeof(Item) + (cell.run.capacity > 0 ? sizeof(void*) : 0); // and malloc's word
    for (const auto& blocks : m_freeBlocks)
        bytes += blocks.capacity() * sizeof(std::uint32_t);
    return bytes;
}

template <TreeKey Value> std::string SceneTree<Value>::faultIn(std::uint32_t node) const
{
    const Cell& cell = m_nodes[node];
    std::uint32_t below = cell.run.count;
    Box own;
    for (std::uint32_t i = 0; i < cell.run.count; ++i) {
        const Item& item = cell.run.items[i];
        own.add(item.box);
        const Place place = placeOf(item.value);
        if (place.node != node || place.item != i) return "a handle points elsewhere";
        if (!inside(m_nodes[0], item.box)) return "an item lies outside the root";
        if (target(item.box) != node) return "an item lies in the wrong node";
    }
    if (!(cell.run.count <= kFitted ? own == cell.own : io::contains(cell.own, own)))
        return "a node's own box does not fit";
    for (std::uint32_t i = 0; i < childCount(cell.split); ++i) {
        const Cell& child = m_nodes[cell.firstChild + i];
        below += child.below;
        if (child.parent != node) return "a child has another parent";
        if (std::string fault = faultIn(cell.firstChild + i); !fault.empty()) return fault;
    }
    if (below != cell.below) return "a node counts wrongly what is below it";
    if (!(fitted(cell) == cell.box)) return "a node's box does not fit";
    if (cell.split == kLeaf && cell.run.count > cell.splitAt) return "a crowded leaf was not split";
    if (cell.split != kLeaf && cell.below <= kThin) return "a thin node was not merged";
    return {};
}

template <TreeKey Value> std::string SceneTree<Value>::validate() const
{
    if (size() == 0) return m_nodes.empty() || m_nodes[0].below == 0 ? "" : "handles are missing";
    if (m_nodes[0].below != size()) return "as many handles as items are expected";
    return faultIn(0);
}

} // namespace io
