#include "editor/history.h"

#include "io/base/log.h"

namespace editor {

void History::push(std::unique_ptr<Command> done)
{
    while (m_steps.size() > m_position) {
        m_bytes -= m_steps.back().bytes;
        m_steps.pop_back();
    }
    const std::size_t bytes = done->bytes();
    m_bytes += bytes;
    m_steps.push_back({std::move(done), ++m_lastState, bytes});
    ++m_position;
    setBudget(m_budget);
}

Command* History::undo()
{
    return canUndo() ? m_steps[--m_position].command.get() : nullptr;
}

Command* History::redo()
{
    return canRedo() ? m_steps[m_position++].command.get() : nullptr;
}

void History::clear()
{
    m_steps.clear();
    m_position = 0;
    m_bytes = 0;
    m_firstState = ++m_lastState;
}

std::vector<std::string> History::names() const
{
    std::vector<std::string> names;
    names.reserve(m_steps.size());
    for (const Step& step : m_steps)
        names.push_back(step.command->name());
    return names;
}

void History::setBudget(std::size_t bytes)
{
    m_budget = bytes;
    const std::uint64_t before = m_dropped;
    // The newest step stays whatever it costs: an edit that cannot be undone at once would be a trap.
    while (m_bytes > m_budget && m_position > 1)
        dropOldest();
    if (m_dropped > 0 && before == 0) // once is enough: from here on every step costs an old one
        io::log::warning("Undo: the memory budget of {} MB is full; the oldest steps can no longer be undone",
                         m_budget >> 20);
}

void History::dropOldest()
{
    m_firstState = m_steps.front().stateAfter;
    m_bytes -= m_steps.front().bytes;
    m_steps.pop_front();
    --m_position;
    ++m_dropped;
}

} // namespace editor
