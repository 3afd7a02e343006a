// GroundWork: a landscape being made beside the window, which shows how far it is and lets a person stop it.
#pragma once

#include "editor/ground_making.h"

#include <atomic>
#include <optional>
#include <thread>

namespace editor {

class GroundWork {
public:
    GroundWork() = default;
    ~GroundWork();
    GroundWork(const GroundWork&) = delete;
    GroundWork& operator=(const GroundWork&) = delete;

    // Instead of what is being made. `beside`: in a thread of its own; otherwise it is made when this returns.
    void start(const GroundRecipe& recipe, bool beside);
    void cancel() { m_cancelled = true; }
    bool busy() const { return m_thread.joinable() || m_done; } // also while one that was cancelled comes to its end
    bool cancelled() const { return m_cancelled; }
    float fraction() const { return m_fraction; }
    std::optional<io::Result<io::HeightGrid>> finished(); // once; nothing of what was cancelled

private:
    void make(const GroundRecipe& recipe);

    std::thread m_thread;
    std::optional<io::Result<io::HeightGrid>> m_made; // the thread's until m_done
    std::atomic<bool> m_done = false, m_cancelled = false;
    std::atomic<float> m_fraction = 0;
};

} // namespace editor
