#include "editor/commands.h"

#include <algorithm>
#include <bit>

namespace editor {
namespace {

template <class T> std::size_t heldBy(const std::vector<T>& values)
{
    return values.capacity() * sizeof(T);
}
std::size_t heldBy(const std::string& text)
{
    return text.capacity() > 15 ? text.capacity() + 1 : 0; // shorter ones lie in the string itself
}
std::size_t heldBy(const io::Environment&)
{
    return 0;
}
std::size_t heldBy(const io::Terrain& terrain)
{
    return heldBy(terrain.heightMap) + heldBy(terrain.layers);
}
std::size_t heldBy(const io::Grass& grass)
{
    return heldBy(grass.map) + heldBy(grass.kinds);
}

std::size_t heldBy(const std::vector<io::ScatterLayer>& layers)
{
    std::size_t bytes = layers.capacity() * sizeof(io::ScatterLayer);
    for (const io::ScatterLayer& layer : layers) {
        bytes += heldBy(layer.name) + heldBy(layer.ground) + layer.species.capacity() * sizeof(io::Species);
        for (const io::Species& species : layer.species)
            bytes += heldBy(species.templateName);
    }
    return bytes;
}

const io::Environment& current(const io::Scene& scene, const io::Environment&)
{
    return scene.environment();
}
const io::Terrain& current(const io::Scene& scene, const io::Terrain&)
{
    return scene.terrain();
}
const io::Grass& current(const io::Scene& scene, const io::Grass&)
{
    return scene.grass();
}
std::span<const io::Camera> current(const io::Scene& scene, const std::vector<io::Camera>&)
{
    return scene.cameras();
}
std::span<const io::CameraPath> current(const io::Scene& scene, const std::vector<io::CameraPath>&)
{
    return scene.paths();
}
std::span<const io::ScatterLayer> current(const io::Scene& scene, const std::vector<io::ScatterLayer>&)
{
    return scene.scatterLayers();
}

template <class T> bool same(std::span<const T> a, const std::vector<T>& b)
{
    return std::ranges::equal(a, b);
}
template <class T> bool same(const T& a, const T& b)
{
    return a == b;
}

io::Changes changesOf(const io::Environment&)
{
    return {.environment = true};
}
io::Changes changesOf(const io::Terrain&)
{
    return {.terrain = true};
}
io::Changes changesOf(const io::Grass&)
{
    return {.grass = true};
}
io::Changes changesOf(const std::vector<io::ScatterLayer>&)
{
    return {.scatter = true};
}
template <class T> io::Changes changesOf(const std::vector<T>&)
{
    return {.cameras = true};
}

} // namespace

io::Changes SwapObjects::swap(io::World& world)
{
    io::Changes changes;
    changes.objects.reserve(m_slots.size());
    for (auto& [id, other] : m_slots) {
        other = world.scene.exchange(id, std::move(other));
        changes.objects.push_back(id);
    }
    return changes;
}

bool SwapObjects::changesNothing(const io::World& world) const
{
    return std::ranges::all_of(m_slots, [&](const Slot& slot) {
        const io::Object* now = world.scene.find(slot.first);
        return now ? slot.second && *now == *slot.second : !slot.second;
    });
}

std::size_t SwapObjects::bytes() const
{
    std::size_t bytes = sizeof *this + heldBy(m_slots) + m_known.size() * 4 * sizeof(void*);
    for (const Slot& slot : m_slots)
        if (slot.second) bytes += heldBy(slot.second->name);
    return bytes;
}

bool SwapObjects::absorb(Command& later)
{
    auto* other = dynamic_cast<SwapObjects*>(&later);
    if (!other) return false;
    if (m_known.empty())
        for (const Slot& slot : m_slots)
            m_known.insert(io::number(slot.first));
    for (Slot& slot : other->m_slots)
        if (m_known.insert(io::number(slot.first)).second) m_slots.push_back(std::move(slot));
    return true;
}

io::Changes SwapTemplate::swap(io::World& world)
{
    m_other = world.scene.exchange(m_id, std::move(m_other));
    return {.templates = {m_id}};
}

bool SwapTemplate::changesNothing(const io::World& world) const
{
    const io::Template* now = world.scene.find(m_id);
    return now ? m_other && *now == *m_other : !m_other;
}

std::size_t SwapTemplate::bytes() const
{
    return sizeof *this + (m_other ? heldBy(m_other->model) + heldBy(m_other->category) : 0);
}

bool SwapTemplate::absorb(Command& later)
{
    const auto* other = dynamic_cast<SwapTemplate*>(&later);
    return other && other->m_id == m_id;
}

template <class Part> io::Changes SwapPart<Part>::swap(io::World& world)
{
    m_other = world.scene.exchange(std::move(m_other));
    return changesOf(m_other);
}

template <class Part> bool SwapPart<Part>::changesNothing(const io::World& world) const
{
    return same(current(world.scene, m_other), m_other);
}

template <class Part> std::size_t SwapPart<Part>::bytes() const
{
    return sizeof *this + heldBy(m_other);
}

template <class Part> bool SwapPart<Part>::absorb(Command& later)
{
    return dynamic_cast<SwapPart<Part>*>(&later) != nullptr;
}

template class SwapPart<io::Environment>;
template class SwapPart<io::Terrain>;
template class SwapPart<io::Grass>;
template class SwapPart<std::vector<io::Camera>>;
template class SwapPart<std::vector<io::CameraPath>>;
template class SwapPart<std::vector<io::ScatterLayer>>;

io::Changes SwapControls::swap(io::World& world)
{
    std::swap(world.project.controls, m_other);
    return {};
}

std::size_t SwapControls::bytes() const
{
    std::size_t bytes = sizeof *this + heldBy(m_other);
    for (const io::Control& control : m_other)
        bytes += heldBy(control.action) + heldBy(control.by);
    return bytes;
}

io::Changes SwapInstances::swap(io::World& world)
{
    io::Changes changes;
    changes.instances.reserve(m_slots.size());
    for (auto& [tile, other] : m_slots) {
        other = world.scene.exchange(tile, std::move(other));
        changes.instances.push_back(tile);
    }
    return changes;
}

bool SwapInstances::changesNothing(const io::World& world) const
{
    return std::ranges::all_of(m_slots, [&](const Slot& slot) {
        const io::InstanceTile* now = world.scene.find(slot.first);
        const io::InstanceTile* other = slot.second && !slot.second->empty() ? slot.second.get() : nullptr;
        return now == other || (now && other && *now == *other);
    });
}

std::size_t SwapInstances::bytes() const
{
    std::size_t bytes = sizeof *this + heldBy(m_slots) + m_known.size() * (sizeof(io::LayerTile) + 4 * sizeof(void*));
    for (const Slot& slot : m_slots)
        if (slot.second) bytes += slot.second->bytes();
    return bytes;
}

bool SwapInstances::absorb(Command& later)
{
    auto* other = dynamic_cast<SwapInstances*>(&later);
    if (!other) return false;
    if (m_known.empty())
        for (const Slot& slot : m_slots)
            m_known.insert(slot.first);
    for (Slot& slot : other->m_slots)
        if (m_known.insert(slot.first).second) m_slots.push_back(std::move(slot));
    return true;
}

namespace {

const std::shared_ptr<const io::HeightMap>& currentMap(const io::Scene& scene, const io::HeightMap*)
{
    return scene.heights();
}
const std::shared_ptr<const io::CoverMap>& currentMap(const io::Scene& scene, const io::CoverMap*)
{
    return scene.cover();
}
const std::shared_ptr<const io::GrassMap>& currentMap(const io::Scene& scene, const io::GrassMap*)
{
    return scene.grassMap();
}
const io::TexelTiles<float>& fieldOf(const io::HeightMap& map)
{
    return map.field();
}
const io::CoverMap& fieldOf(const io::CoverMap& map)
{
    return map;
}
const io::TexelTiles<std::uint32_t>& fieldOf(const io::GrassMap& map)
{
    return map.field();
}
io::HeightMap withField(const io::HeightMap& map, io::TexelTiles<float> field)
{
    return map.with(std::move(field));
}
io::CoverMap withField(const io::CoverMap&, io::CoverMap field)
{
    return field;
}
io::GrassMap withField(const io::GrassMap& map, io::TexelTiles<std::uint32_t> field)
{
    return map.with(std::move(field));
}
io::Changes changesOf(const io::HeightMap*, const io::TexelRect& rect)
{
    return {.heights = {rect}};
}
io::Changes changesOf(const io::CoverMap*, const io::TexelRect& rect)
{
    return {.cover = {rect}};
}
io::Changes changesOf(const io::GrassMap*, const io::TexelRect& rect)
{
    return {.grassMap = {rect}};
}

// Where the ground lies may have been changed by another command of the same step.
void placeAs(const io::HeightMap& now, std::shared_ptr<const io::HeightMap>& other)
{
    if (now.metresPerTexel != other->metresPerTexel || now.origin != other->origin)
        other = std::make_shared<const io::HeightMap>(other->placed(now.metresPerTexel, now.origin));
}
void placeAs(const io::CoverMap&, std::shared_ptr<const io::CoverMap>&) {}
void placeAs(const io::GrassMap& now, std::shared_ptr<const io::GrassMap>& other)
{
    if (now.metresPerTexel != other->metresPerTexel || now.origin != other->origin)
        other = std::make_shared<const io::GrassMap>(other->field(), now.metresPerTexel, now.origin);
}

template <class Map> bool sameShape(const Map* a, const Map* b)
{
    return a && b && fieldOf(*a).size() == fieldOf(*b).size();
}

// What is packed takes all but the texels from the map that is there.
bool sameKind(const io::HeightMap& a, const io::HeightMap& b)
{
    return a.shares == b.shares;
}
bool sameKind(const io::CoverMap&, const io::CoverMap&)
{
    return true;
}
bool sameKind(const io::GrassMap&, const io::GrassMap&)
{
    return true;
}

// The four bytes of each number apart, as like bytes pack better beside each other.
template <class T> std::vector<std::byte> differenceOf(const std::vector<T>& a, const std::vector<T>& b)
{
    std::vector<std::byte> planes(io::kTileTexels * 4);
    for (std::size_t i = 0; i < io::kTileTexels; ++i) {
        const std::uint32_t bits = std::bit_cast<std::uint32_t>(a[i]) ^ std::bit_cast<std::uint32_t>(b[i]);
        for (std::size_t plane = 0; plane < 4; ++plane)
            planes[plane * io::kTileTexels + i] = std::byte(bits >> (8 * plane));
    }
    return planes;
}

template <class T> std::vector<T> applied(std::vector<T> texels, const std::vector<std::byte>& planes)
{
    for (std::size_t i = 0; i < io::kTileTexels; ++i) {
        std::uint32_t bits = 0;
        for (std::size_t plane = 0; plane < 4; ++plane)
            bits |= std::uint32_t(planes[plane * io::kTileTexels + i]) << (8 * plane);
        texels[i] = std::bit_cast<T>(std::bit_cast<std::uint32_t>(texels[i]) ^ bits);
    }
    return texels;
}

} // namespace

template <class Map> io::Changes SwapGround<Map>::swap(io::World& world)
{
    constexpr const Map* kKind = nullptr;
    const std::shared_ptr<const Map> now = currentMap(world.scene, kKind);
    if (m_packed) {
        const auto& field = fieldOf(*now);
        std::vector<std::pair<glm::ivec2, typename std::remove_cvref_t<decltype(field)>::Tile>> tiles;
        for (const Difference& difference : m_differences)
            tiles.emplace_back(difference.tile, applied(*field.tile(difference.tile), difference.bits.unpacked()));
        world.scene.exchange(std::make_shared<const Map>(withField(*now, field.withTiles(std::move(tiles)))));
        return changesOf(kKind, m_changed);
    }
    if (now && m_other) placeAs(*now, m_other);
    io::TexelRect all = m_changed;
    if (!sameShape(now.get(), m_other.get())) {
        if (now) all = around(all, fieldOf(*now).rect());
        if (m_other) all = around(all, fieldOf(*m_other).rect());
    }
    m_other = world.scene.exchange(std::move(m_other));
    const Map* here = currentMap(world.scene, kKind).get();
    m_tiles = 0;
    if (sameShape(here, m_other.get()))
        fieldOf(*here).eachOther(fieldOf(*m_other), [this](glm::ivec2) { ++m_tiles; });
    else if (m_other)
        m_tiles = fieldOf(*m_other).bytes() / (io::kTileTexels * 4);
    return changesOf(kKind, all);
}

template <class Map> bool SwapGround<Map>::changesNothing(const io::World& world) const
{
    if (m_packed) return m_differences.empty();
    const auto& now = currentMap(world.scene, static_cast<const Map*>(nullptr));
    return now == m_other || (now && m_other && *now == *m_other);
}

template <class Map> std::size_t SwapGround<Map>::bytes() const
{
    std::size_t bytes = sizeof *this + m_tiles * io::kTileTexels * 4;
    for (const Difference& difference : m_differences)
        bytes += sizeof difference + difference.bits.bytes();
    return bytes;
}

template <class Map> bool SwapGround<Map>::absorb(Command& later)
{
    const auto* other = dynamic_cast<SwapGround*>(&later);
    if (!other) return false;
    m_changed = around(m_changed, other->m_changed);
    return true;
}

template <class Map> void SwapGround<Map>::pack(const io::World& world)
{
    const auto& now = currentMap(world.scene, static_cast<const Map*>(nullptr));
    if (m_packed || !sameShape(now.get(), m_other.get()) || !sameKind(*now, *m_other)) return;
    const auto &field = fieldOf(*now), &other = fieldOf(*m_other);
    field.eachOther(other, [&](glm::ivec2 tile) {
        m_differences.push_back({tile, io::PackedBytes{differenceOf(*field.tile(tile), *other.tile(tile))}});
    });
    m_other = nullptr;
    m_tiles = 0;
    m_packed = true;
}

template class SwapGround<io::HeightMap>;
template class SwapGround<io::CoverMap>;
template class SwapGround<io::GrassMap>;

void Composite::pack(const io::World& world)
{
    for (const auto& command : m_commands)
        command->pack(world);
}

void Composite::add(std::unique_ptr<Command> done)
{
    for (const auto& earlier : m_commands)
        if (earlier->absorb(*done)) return;
    m_commands.push_back(std::move(done));
}

io::Changes Composite::swap(io::World& world)
{
    io::Changes changes;
    for (const auto& command : m_commands)
        changes.add(command->swap(world));
    return changes;
}

bool Composite::changesNothing(const io::World& world) const
{
    return std::ranges::all_of(m_commands, [&](const auto& command) { return command->changesNothing(world); });
}

std::size_t Composite::bytes() const
{
    std::size_t bytes = sizeof *this;
    for (const auto& command : m_commands)
        bytes += command->bytes();
    return bytes;
}

} // namespace editor
