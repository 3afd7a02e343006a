#include "renderer/lamps.h"

#include "renderer/shaders/shared/lamps.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr float kMostIntensity = 1e6f;

bool isFinite(const io::Transform& t)
{
    return std::isfinite(t.position.x + t.position.y + t.position.z + t.rotation.x + t.rotation.y + t.rotation.z + t.scale.x +
                         t.scale.y + t.scale.z);
}

// Irradiance where the eye is, if it is outside of the range as at its edge.
float brightness(const Lamp& lamp, const glm::dvec3& eye)
{
    const double away = glm::distance(lamp.place, eye);
    const float strongest = std::max({lamp.intensity.r, lamp.intensity.g, lamp.intensity.b});
    return strongest * lamp.range / float(std::max(away * away, 1.0));
}

bool sees(const Volume& volume, const Lamp& lamp)
{
    return std::ranges::all_of(volume.planes, [&](const glm::dvec4& plane) {
        return glm::dot(glm::dvec3{plane}, lamp.place) + plane.w + double(lamp.range) >= 0;
    });
}

} // namespace

std::optional<Lamp> lampOf(const io::Object& object, const io::LightSource& light)
{
    if (light.kind == io::LightKind::None || !isFinite(object.transform)) return std::nullopt;
    const glm::mat3 linear = io::linearPart(object.transform);
    Lamp lamp{.object = object.id, .templateId = object.templateId, .castShadow = light.castShadow};
    lamp.place = object.transform.position + glm::dvec3{linear * light.offset};
    lamp.intensity = glm::clamp(light.colour * light.intensity, 0.0f, kMostIntensity);
    lamp.range = light.range;
    const glm::vec3 along = linear * glm::vec3{0, 0, -1};
    if (light.kind == io::LightKind::Spot && glm::length(along) > 0) {
        lamp.direction = glm::normalize(along);
        lamp.outer = glm::radians(glm::clamp(light.outer, 1.0f, 89.0f));
        lamp.inner = glm::clamp(glm::radians(light.inner), 0.0f, lamp.outer);
    }
    const float sum = lamp.intensity.r + lamp.intensity.g + lamp.intensity.b + float(glm::length(lamp.place)) + lamp.direction.x + lamp.outer;
    const bool shines = std::isfinite(sum) && lamp.range > LAMP_RADIUS && lamp.intensity != glm::vec3{0};
    return shines ? std::optional{lamp} : std::nullopt;
}

void Lamps::update(const io::Scene& scene, const io::Changes& changes)
{
    if (changes.everything) {
        m_lamps.clear();
        m_rowOf.clear();
        for (const io::Object& object : scene.objects())
            updateObject(scene, object.id);
        return;
    }
    if (!changes.templates.empty()) updateTemplates(scene, changes.templates);
    for (const io::ObjectId id : changes.objects)
        updateObject(scene, id);
}

// Copies are looked for only where one of the templates has a light, or had.
void Lamps::updateTemplates(const io::Scene& scene, std::span<const io::TemplateId> ids)
{
    const auto isOne = [&](io::TemplateId id) { return std::ranges::find(ids, id) != ids.end(); };
    const auto shines = [&](io::TemplateId id) {
        const io::Template* value = scene.find(id);
        return value && value->light.kind != io::LightKind::None;
    };
    const auto shone = [&](const Lamp& lamp) { return isOne(lamp.templateId); };
    if (std::ranges::none_of(ids, shines) && std::ranges::none_of(m_lamps, shone)) return;
    for (const io::Object& object : scene.objects())
        if (isOne(object.templateId)) updateObject(scene, object.id);
}

void Lamps::updateObject(const io::Scene& scene, io::ObjectId id)
{
    const io::Object* object = scene.find(id);
    const io::Template* value = object ? scene.find(object->templateId) : nullptr;
    const std::optional<Lamp> lamp = value ? lampOf(*object, value->light) : std::nullopt;
    if (!lamp) return remove(id);
    const auto [known, isNew] = m_rowOf.try_emplace(io::number(id), m_lamps.size());
    if (isNew) m_lamps.push_back(*lamp);
    else m_lamps[known->second] = *lamp;
}

void Lamps::remove(io::ObjectId id)
{
    const auto known = m_rowOf.find(io::number(id));
    if (known == m_rowOf.end()) return;
    const std::size_t row = known->second;
    m_rowOf.erase(known);
    if (row + 1 != m_lamps.size()) { // the last one takes its place
        m_lamps[row] = m_lamps.back();
        m_rowOf[io::number(m_lamps[row].object)] = row;
    }
    m_lamps.pop_back();
}

std::vector<Lamp> Lamps::inView(const Eye& eye, std::size_t most) const
{
    if (m_lamps.empty()) return {};
    const Volume volume = volumeOf(eye);
    std::vector<std::pair<float, const Lamp*>> seen;
    for (const Lamp& lamp : m_lamps)
        if (sees(volume, lamp)) seen.emplace_back(brightness(lamp, eye.position), &lamp);
    const auto before = [](const auto& a, const auto& b) {
        return a.first != b.first ? a.first > b.first : a.second->object < b.second->object;
    };
    const std::size_t count = std::min(seen.size(), most);
    std::partial_sort(seen.begin(), seen.begin() + std::ptrdiff_t(count), seen.end(), before);
    std::vector<Lamp> lamps;
    for (std::size_t i = 0; i < count; ++i)
        lamps.push_back(*seen[i].second);
    return lamps;
}

} // namespace renderer
