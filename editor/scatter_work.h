// ScatterWork: the rules of a layer being evaluated beside the window, which shows how far it is and lets a person stop it.
#pragma once

#include "editor/scatter_edits.h"

#include <atomic>
#include <memory>
#include <optional>
#include <thread>

namespace editor {

class ScatterWork {
public:
    ScatterWork() = default;
    ~ScatterWork();
    ScatterWork(const ScatterWork&) = delete;
    ScatterWork& operator=(const ScatterWork&) = delete;

    // Instead of what is being done: evaluates a rule layer, plants all over another. `beside`: in a thread of its own, if the
    // planting allows; otherwise it is done when this returns.
    void start(const io::Scene& scene, LayerTiles layer, Planting planting, bool beside);
    void cancel() { m_cancelled = true; }
    bool busy() const { return m_thread.joinable() || m_done; }
    float fraction() const { return m_fraction; }
    bool ready() const { return m_done; } // finished() has something to say
    // Once; nothing of what was cancelled, or where the layer's tiles or the ground are not what they were any more.
    std::optional<InstanceSlots> finished(const io::Scene& scene);
    bool late() const { return m_late; } // so the last one was, and somebody should be told

private:
    void make();

    std::optional<LayerTiles> m_layer;
    std::shared_ptr<const io::HeightMap> m_heights;
    std::shared_ptr<const io::CoverMap> m_cover;
    bool m_late = false;
    std::optional<Planting> m_planting;
    std::thread m_thread;
    std::optional<InstanceSlots> m_made; // the thread's until m_done
    std::atomic<bool> m_done = false, m_cancelled = false;
    std::atomic<float> m_fraction = 0;
};

} // namespace editor
