// History: the steps that were done and can be undone, within a budget of memory.
#pragma once

#include "editor/command.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace editor {

class History {
public:
    static constexpr std::size_t kDefaultBudget = std::size_t(256) << 20; // bytes

    void push(std::unique_ptr<Command> done); // what could be redone is forgotten; the oldest go when over budget
    Command* undo();                          // the command to swap, null when there is none
    Command* redo();
    void clear();

    bool canUndo() const { return m_position > 0; }
    bool canRedo() const { return m_position < m_steps.size(); }
    std::vector<std::string> names() const;             // oldest first, those that can be redone too
    std::size_t position() const { return m_position; } // how many of the names are done
    std::size_t bytes() const { return m_bytes; }
    std::uint64_t dropped() const { return m_dropped; } // steps that the budget has cost, ever
    void setBudget(std::size_t bytes);

    // A number for the state that the world is in; the same number means the same state.
    std::uint64_t state() const { return m_position > 0 ? m_steps[m_position - 1].stateAfter : m_firstState; }

private:
    struct Step {
        std::unique_ptr<Command> command;
        std::uint64_t stateAfter = 0;
        std::size_t bytes = 0;
    };
    void dropOldest();

    std::deque<Step> m_steps;
    std::size_t m_position = 0;
    std::size_t m_bytes = 0;
    std::size_t m_budget = kDefaultBudget;
    std::uint64_t m_dropped = 0;
    std::uint64_t m_firstState = 0;
    std::uint64_t m_lastState = 0;
};

} // namespace editor
