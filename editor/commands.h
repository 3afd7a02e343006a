// The commands: objects, templates, and the single parts of a scene (environment, terrain, cameras, paths).
#pragma once

#include "editor/command.h"

#include <memory>
#include <optional>
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

// A part of which a scene has one: Environment, Terrain, std::vector<Camera> or std::vector<CameraPath>.
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
using SwapCameras = SwapPart<std::vector<io::Camera>>;
using SwapPaths = SwapPart<std::vector<io::CameraPath>>;

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

private:
    std::vector<std::unique_ptr<Command>> m_commands;
};

} // namespace editor
