// Command: a change of a world that holds what the world does not hold now. Doing, undoing and redoing are one
// call, swap(), which exchanges the two.
#pragma once

#include "io/files/project.h"
#include "io/scene/changes.h"

#include <cstddef>
#include <string>

namespace editor {

class Command {
public:
    explicit Command(std::string name) : m_name{std::move(name)} {}
    virtual ~Command() = default;
    Command(const Command&) = delete;
    Command& operator=(const Command&) = delete;

    const std::string& name() const { return m_name; } // as the Edit menu shows it: "Move 3 objects"
    void rename(std::string name) { m_name = std::move(name); }

    virtual io::Changes swap(io::World& world) = 0;
    virtual bool changesNothing(const io::World& world) const = 0; // swapping now would leave the world as it is
    virtual std::size_t bytes() const = 0;                         // memory held, for the budget

    // Called once when the step goes into the history, already done: time to become small.
    virtual void pack(const io::World& world) { (void)world; }

    // Makes this step, already done, also undo `later`, done after it; keeps its own older values. False: cannot.
    virtual bool absorb(Command& later)
    {
        (void)later;
        return false;
    }

private:
    std::string m_name;
};

} // namespace editor
