#include "editor/scatter_work.h"

#include <utility>

namespace editor {

ScatterWork::~ScatterWork()
{
    cancel();
    if (m_thread.joinable()) m_thread.join();
}

void ScatterWork::start(const io::Scene& scene, LayerTiles layer, Planting planting, bool beside)
{
    cancel();
    if (m_thread.joinable()) m_thread.join();
    m_layer = std::move(layer);
    m_heights = scene.heights();
    m_cover = scene.cover();
    m_planting.emplace(std::move(planting));
    m_made.reset();
    m_done = m_cancelled = false;
    m_fraction = 0;
    if (beside && m_planting->beside())
        m_thread = std::thread{[this] { make(); }};
    else
        make();
}

void ScatterWork::make()
{
    const io::Progress progress = [this](float fraction, std::string_view) {
        m_fraction = fraction;
        return !m_cancelled;
    };
    const PlantRegion all = PlantRegion::everywhere();
    if (m_layer->rule) m_made = evaluated(*m_layer, *m_planting, all.bounds(), progress);
    else m_made = planted(*m_layer, *m_planting, all, progress);
    m_done = true;
}

std::optional<InstanceSlots> ScatterWork::finished(const io::Scene& scene)
{
    if (!m_done) return std::nullopt;
    if (m_thread.joinable()) m_thread.join();
    m_done = false;
    std::optional<InstanceSlots> made = std::exchange(m_made, std::nullopt);
    m_late = !m_cancelled && (!scene.find(m_layer->layer) || scene.instances(m_layer->layer) != m_layer->tiles || scene.heights() != m_heights || scene.cover() != m_cover);
    if (m_cancelled || m_late) made.reset();
    return made;
}

} // namespace editor
