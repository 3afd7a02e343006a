#include "app/sound/sound_sources.h"

#include "io/scene/falloff.h"
#include "io/scene/instance_walk.h"

#include <algorithm>

namespace app {
namespace {

constexpr float kStormWind = 12; // m/s

bool sounds(const io::Template* what)
{
    return what && !what->sound.file.empty();
}

SoundSources::Place placeOf(io::ObjectId id, io::TemplateId templateId, const io::Transform& transform, const io::Template& what)
{
    const glm::dvec3 offset{linearPart(transform) * what.sound.offset};
    return {.at = transform.position + offset, .radius = what.sound.radius, .object = id, .what = templateId};
}
SoundSources::Place placeOf(const io::Object& object, const io::Template& what)
{
    return placeOf(object.id, object.templateId, object.transform, what);
}

} // namespace

void SoundSources::follow(const io::Scene& scene, const io::Changes& changes)
{
    const auto touches = [&](io::TemplateId id) {
        const std::size_t slot = number(id) - 1;
        return sounds(scene.find(id)) || (slot < m_sounding.size() && m_sounding[slot]);
    };
    const bool planted = changes.scatter || std::ranges::any_of(changes.instances, [&](const io::LayerTile& tile) { return soundsIn(scene, tile.layer); });
    if (!m_built || changes.everything || planted || std::ranges::any_of(changes.templates, touches)) return rebuild(scene);
    for (const io::ObjectId id : changes.objects)
        followObject(scene, id);
}

void SoundSources::rebuild(const io::Scene& scene)
{
    m_built = true;
    m_places.clear();
    m_indexOf.clear();
    m_sounding.clear();
    bool any = false;
    for (const io::Scene::TemplateSlot& slot : scene.templates()) {
        m_sounding.push_back(slot.value && sounds(&*slot.value));
        any |= m_sounding.back();
    }
    if (!any) return;
    for (const io::Object& object : scene.objects()) {
        const std::uint32_t slot = number(object.templateId);
        if (slot == 0 || !m_sounding[slot - 1]) continue;
        m_indexOf.emplace(object.id, m_places.size());
        m_places.push_back(placeOf(object, *scene.find(object.templateId)));
    }
    addPlanted(scene);
}

bool SoundSources::soundsIn(const io::Scene& scene, io::ScatterId layer) const
{
    const io::ScatterLayer* const own = scene.find(layer);
    return !own || std::ranges::any_of(io::templatesOf(scene, *own), [&](io::TemplateId id) { return sounds(scene.find(id)); });
}

void SoundSources::addPlanted(const io::Scene& scene)
{
    for (const io::ScatterLayer& layer : scene.scatterLayers()) {
        if (!soundsIn(scene, layer.id)) continue;
        for (const auto& [place, tile] : scene.instances(layer.id))
            io::eachInstance(scene, {layer.id, place}, [&](io::ObjectId id, io::TemplateId templateId, const io::Transform& transform) {
                if (const io::Template* what = scene.find(templateId); sounds(what)) m_places.push_back(placeOf(id, templateId, transform, *what));
            });
    }
}

void SoundSources::followObject(const io::Scene& scene, io::ObjectId id)
{
    const io::Object* const object = scene.find(id);
    const io::Template* const what = object ? scene.find(object->templateId) : nullptr;
    const auto known = m_indexOf.find(id);
    if (sounds(what)) {
        if (known != m_indexOf.end())
            m_places[known->second] = placeOf(*object, *what);
        else {
            m_indexOf.emplace(id, m_places.size());
            m_places.push_back(placeOf(*object, *what));
        }
        return;
    }
    if (known == m_indexOf.end()) return;
    const std::size_t gap = known->second;
    m_indexOf.erase(known);
    if (gap + 1 < m_places.size()) {
        m_places[gap] = m_places.back();
        if (const auto moved = m_indexOf.find(m_places[gap].object); moved != m_indexOf.end()) moved->second = gap; // the planted have no entry
    }
    m_places.pop_back();
}

float levelAt(const io::SoundSource& source, double distance)
{
    const float at = float(distance / std::max(double(source.radius), 1e-6));
    return at < 1 ? io::falloffAt(source.falloff, at) : 0;
}

bool heardAt(const io::SoundSource& source, const io::Environment& environment)
{
    const float from = source.hours.x, to = source.hours.y;
    const float hour = environment.time >= 24 ? environment.time - 24 : environment.time;
    const bool inHours = from <= to ? (hour >= from && hour < to) : (hour >= from || hour < to);
    if (!inHours) return false;
    const bool wet = environment.weather.rain > 0 || environment.weather.snow > 0;
    switch (source.weather) {
    case io::SoundWeather::Any: return true;
    case io::SoundWeather::Dry: return !wet;
    case io::SoundWeather::Wet: return wet;
    case io::SoundWeather::Storm: return wet && environment.wind.speed > kStormWind;
    }
    return true;
}

} // namespace app
