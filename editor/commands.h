// The commands: objects, templates, and the single parts of a scene (environment, terrain, cameras, paths).
#pragma once

#include "editor/command.h"
#include "io/files/packed_bytes.h"

#include <memory>
#include <optional>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

namespace editor {

// Adds, deletes, moves, renames, re-parents and edits objects: an empty value means "no such object".
class SwapObjects final : public Command {
public:
    using Slot = std::pair<io::ObjectId, std::optional<io::Object>>;
    SwapObjects(std::string name, std::vector<Slot> slots) : Command{std::move(name)}, m_slots{std::move(slots)} {}

    io::Changes swap(io::World& world) override;
    bool changesNothing(const io::World& world) const override;
    std::size_t bytes() const override;
    bool absorb(Command& later) override;

private:
    std::vector<Slot> m_slots;                 // an id appears once
    std::unordered_set<std::uint32_t> m_known; // ids of m_slots, filled when something is absorbed
};

class SwapTemplate final : public Command {
public:
    SwapTemplate(std::string name, io::TemplateId id, std::optional<io::Template> value)
        : Command{std::move(name)}, m_id{id}, m_other{std::move(value)}
    {
    }
    io::Changes swap(io::World& world) override;
    bool changesNothing(const io::World& world) const override;
    std::size_t bytes() const override;
    bool absorb(Command& later) override;

private:
    io::TemplateId m_id;
    std::optional<io::Template> m_other;
};

// A part of which a scene has one: Environment, Terrain, Grass, or the list of cameras, camera paths or scatter layers.
template <class Part> class SwapPart final : public Command {
public:
    SwapPart(std::string name, Part value) : Command{std::move(name)}, m_other{std::move(value)} {}
    io::Changes swap(io::World& world) override;
    bool changesNothing(const io::World& world) const override;
    std::size_t bytes() const override;
    bool absorb(Command& later) override;

private:
    Part m_other;
};

using SwapEnvironment = SwapPart<io::Environment>;
using SwapTerrain = SwapPart<io::Terrain>;
using SwapGrass = SwapPart<io::Grass>;
using SwapCameras = SwapPart<std::vector<io::Camera>>;
using SwapPaths = SwapPart<std::vector<io::CameraPath>>;
using SwapScatterLayers = SwapPart<std::vector<io::ScatterLayer>>;

// What makes the player of the project do something.
class SwapControls final : public Command {
public:
    SwapControls(std::string name, std::vector<io::Control> controls) : Command{std::move(name)}, m_other{std::move(controls)} {}
    io::Changes swap(io::World& world) override;
    bool changesNothing(const io::World& world) const override { return world.project.controls == m_other; }
    std::size_t bytes() const override;
    bool absorb(Command& later) override { return dynamic_cast<SwapControls*>(&later) != nullptr; }

private:
    std::vector<io::Control> m_other;
};

// Instances of scatter layers, by the tiles that are touched: a stroke, a filled layer, one that was moved. A tile without a
// value holds none.
class SwapInstances final : public Command {
public:
    using Slot = std::pair<io::LayerTile, std::shared_ptr<const io::InstanceTile>>;
    SwapInstances(std::string name, std::vector<Slot> slots) : Command{std::move(name)}, m_slots{std::move(slots)} {}

    io::Changes swap(io::World& world) override;
    bool changesNothing(const io::World& world) const override;
    std::size_t bytes() const override;
    bool absorb(Command& later) override;

private:
    std::vector<Slot> m_slots;     // a tile appears once
    std::set<io::LayerTile> m_known; // those of m_slots, filled when something is absorbed
};

// A field of the ground, io::HeightMap, io::CoverMap or io::GrassMap: a stroke of a brush, or another map altogether. Until it is packed it
// holds the other map, which has in common with the scene's what did not change; then only the bits in which the touched
// tiles differ.
template <class Map> class SwapGround final : public Command {
public:
    // `changed`: where the two maps differ; all of it where they are not of one size.
    SwapGround(std::string name, std::shared_ptr<const Map> map, const io::TexelRect& changed)
        : Command{std::move(name)}, m_other{std::move(map)}, m_changed{changed}
    {
    }
    io::Changes swap(io::World& world) override;
    bool changesNothing(const io::World& world) const override;
    std::size_t bytes() const override;
    bool absorb(Command& later) override;
    void pack(const io::World& world) override;

private:
    struct Difference {
        glm::ivec2 tile;
        io::PackedBytes bits; // of the one's texels, exclusive or with those of the other
    };
    std::shared_ptr<const Map> m_other; // null: none, or packed
    io::TexelRect m_changed;
    std::vector<Difference> m_differences; // once packed
    bool m_packed = false;
    std::size_t m_tiles = 0; // that m_other does not share
};

using SwapHeights = SwapGround<io::HeightMap>;
using SwapCover = SwapGround<io::CoverMap>;
using SwapGrassMap = SwapGround<io::GrassMap>;

// Several commands, already done, as one step. Those that cannot absorb each other touch different things, so the
// order in which they are swapped does not matter.
class Composite final : public Command {
public:
    using Command::Command;
    void add(std::unique_ptr<Command> done); // merged into what it holds where it can be
    bool empty() const { return m_commands.empty(); }

    io::Changes swap(io::World& world) override;
    bool changesNothing(const io::World& world) const override;
    std::size_t bytes() const override;
    void pack(const io::World& world) override;

private:
    std::vector<std::unique_ptr<Command>> m_commands;
};

} // namespace editor
