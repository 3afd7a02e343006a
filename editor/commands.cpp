#include "editor/commands.h"

#include <algorithm>

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

const io::Environment& current(const io::Scene& scene, const io::Environment&)
{
    return scene.environment();
}
const io::Terrain& current(const io::Scene& scene, const io::Terrain&)
{
    return scene.terrain();
}
std::span<const io::Camera> current(const io::Scene& scene, const std::vector<io::Camera>&)
{
    return scene.cameras();
}
std::span<const io::CameraPath> current(const io::Scene& scene, const std::vector<io::CameraPath>&)
{
    return scene.paths();
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
template class SwapPart<std::vector<io::Camera>>;
template class SwapPart<std::vector<io::CameraPath>>;

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
