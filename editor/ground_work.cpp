#include "editor/ground_work.h"

#include <utility>

namespace editor {

GroundWork::~GroundWork()
{
    cancel();
    if (m_thread.joinable()) m_thread.join();
}

void GroundWork::start(const GroundRecipe& recipe, bool beside)
{
    cancel();
    if (m_thread.joinable()) m_thread.join();
    m_made.reset();
    m_done = m_cancelled = false;
    m_fraction = 0;
    if (beside)
        m_thread = std::thread{[this, recipe] { make(recipe); }};
    else
        make(recipe);
}

void GroundWork::make(const GroundRecipe& recipe)
{
    m_made.emplace(generateGround(recipe, [this](float fraction, std::string_view) {
        m_fraction = fraction;
        return !m_cancelled;
    }));
    m_done = true;
}

std::optional<io::Result<io::HeightGrid>> GroundWork::finished()
{
    if (!m_done) return std::nullopt;
    if (m_thread.joinable()) m_thread.join();
    m_done = false;
    std::optional<io::Result<io::HeightGrid>> made = std::exchange(m_made, std::nullopt);
    if (m_cancelled) made.reset();
    return made;
}

} // namespace editor
