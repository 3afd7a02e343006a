#include "renderer/particles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace renderer {
namespace {

constexpr double kSmallestPixels = 1.5; // of a column of particles, under which it is left out
constexpr double kMostOfOne = 20000;    // particles of one source
constexpr double kTimePeriod = 8192;    // s, of the gusts that births feel
constexpr float kNearGround = 0.6f;     // share of the wind that is left where things burn

bool finite(const io::Transform& t)
{
    return std::isfinite(t.position.x + t.position.y + t.position.z) && std::isfinite(t.rotation.x + t.rotation.y + t.rotation.z) &&
           std::isfinite(t.scale.x + t.scale.y + t.scale.z);
}

struct Habit { // of a kind
    float windShare, riseShare; // of what a particle ends with
    float settle, swirl;        // s; m/s
};

Habit habitOf(io::ParticleKind kind)
{
    switch (kind) {
    case io::ParticleKind::Fire: return {0.18f, 1.5f, 0.5f, 0.10f}; // hot gas speeds up
    case io::ParticleKind::Dust: return {0.8f, -0.08f, 0.8f, 0.20f};
    case io::ParticleKind::Smoke:
    case io::ParticleKind::None: break;
    }
    return {1.0f, 0.7f, 1.6f, 0.16f};
}

glsl::ParticleSource sourceOf(const ParticleSources::Placed& placed, const ParticleRequest& request, double time)
{
    const Habit habit = habitOf(placed.what.kind);
    const double direction = glm::radians(double(request.wind.direction));
    const glm::vec3 wind = glm::vec3{float(std::sin(direction)), 0, float(-std::cos(direction))} * request.wind.speed * kNearGround;
    const float rise = placed.what.rise * placed.scale;
    return {.origin = glm::vec3{placed.position - request.eye.position},
            .size = std::max(placed.what.size * placed.scale, 0.001f),
            .start = {0, rise, 0},
            .spread = placed.what.spread * placed.scale,
            .drift = wind * habit.windShare + glm::vec3{0, rise * habit.riseShare, 0},
            .settle = habit.settle,
            .colour = placed.what.colour,
            .life = placed.what.life,
            .gust = request.wind.gustiness,
            .swirl = habit.swirl * (0.4f + 0.2f * std::min(request.wind.speed, 10.0f)),
            .time = float(time - std::floor(time / kTimePeriod) * kTimePeriod),
            .kind = std::uint32_t(placed.what.kind)};
}

// A sphere around all that a source has in the air, m from the eye.
glm::dvec4 reachOf(const glsl::ParticleSource& s)
{
    const glm::vec3 drift = s.drift * glm::vec3{1 + s.gust, 2.4f, 1 + s.gust};
    const glm::vec3 farthest = drift * s.life;
    const float beside = 1.2f * s.size + s.spread * (1 + 1.2f * s.settle) + 2.4f * glm::length(s.start) * s.settle +
                         4 * s.swirl * s.life / (1 + 0.35f * s.life);
    return {glm::dvec3{s.origin + 0.5f * farthest}, double(0.5f * glm::length(farthest) + beside)};
}

bool seen(const glm::dvec4& reach, const ParticleRequest& request)
{
    const double distance = glm::length(glm::dvec3{reach});
    if (reach.w < kSmallestPixels * pixelAngle(request.eye) * std::max(distance - reach.w, 0.0)) return false;
    if (!request.volume) return true;
    const glm::dvec3 middle = glm::dvec3{reach} + request.eye.position;
    return std::ranges::none_of(request.volume->planes, [&](const glm::dvec4& p) {
        return glm::dot(glm::dvec3{p}, middle) + p.w < -reach.w * glm::length(glm::dvec3{p});
    });
}

// Each source has births of its own: whole numbers since long ago, one every 1 / rate seconds.
double ownTime(const ParticleSources::Placed& placed, double time)
{
    return time + 97.0 * double(glsl::particleRandom(io::number(placed.id), 5u));
}

double steady(const io::ParticleSource& what)
{
    return std::min(double(what.rate) * double(what.life), kMostOfOne);
}

} // namespace

void ParticleSources::update(const io::Scene& scene, const io::Changes& changes)
{
    if (changes.everything) {
        m_gives.clear();
        m_placed.clear();
        m_rowOf.clear();
        for (std::size_t i = 0; i < scene.templates().size(); ++i)
            readTemplate(scene, io::TemplateId(i + 1));
    }
    for (const io::TemplateId id : changes.templates)
        if (id != io::TemplateId::None) readTemplate(scene, id);
    const bool none = std::ranges::find(m_gives, true) == m_gives.end();
    if (none && m_placed.empty()) return;
    if (changes.everything || !changes.templates.empty()) {
        for (const io::Object& object : scene.objects())
            if (changes.everything || std::ranges::find(changes.templates, object.templateId) != changes.templates.end()) place(scene, object.id);
    }
    for (const io::ObjectId id : changes.objects)
        place(scene, id);
}

void ParticleSources::readTemplate(const io::Scene& scene, io::TemplateId id)
{
    const std::size_t slot = io::number(id) - 1;
    if (m_gives.size() <= slot) m_gives.resize(slot + 1);
    const io::Template* value = scene.find(id);
    m_gives[slot] = value && value->particles.kind != io::ParticleKind::None && steady(value->particles) > 0;
}

bool ParticleSources::gives(io::TemplateId id) const
{
    const std::uint32_t n = io::number(id);
    return n > 0 && n <= m_gives.size() && m_gives[n - 1];
}

void ParticleSources::place(const io::Scene& scene, io::ObjectId id)
{
    const io::Object* object = scene.find(id);
    if (!object || !gives(object->templateId) || !finite(object->transform)) return remove(id);
    const io::ParticleSource& what = scene.find(object->templateId)->particles;
    const glm::mat3 linear = io::linearPart(object->transform);
    const glm::vec3 scale = glm::abs(object->transform.scale);
    const Placed placed{.id = id,
                        .position = object->transform.position + glm::dvec3{linear * what.offset},
                        .scale = (scale.x + scale.y + scale.z) / 3,
                        .what = what};
    const auto [known, fresh] = m_rowOf.try_emplace(io::number(id), m_placed.size());
    if (fresh) m_placed.push_back(placed);
    else m_placed[known->second] = placed;
}

void ParticleSources::remove(io::ObjectId id)
{
    const auto known = m_rowOf.find(io::number(id));
    if (known == m_rowOf.end()) return;
    const std::size_t row = known->second;
    m_rowOf.erase(known);
    if (row + 1 < m_placed.size()) {
        m_placed[row] = m_placed.back();
        m_rowOf[io::number(m_placed[row].id)] = row;
    }
    m_placed.pop_back();
}

Particles particlesOf(std::span<const ParticleSources::Placed> placed, const ParticleRequest& request)
{
    struct Shown {
        const ParticleSources::Placed* placed;
        glsl::ParticleSource source;
        double away;
    };
    std::vector<Shown> shown;
    for (const ParticleSources::Placed& one : placed) {
        const glsl::ParticleSource source = sourceOf(one, request, ownTime(one, request.time));
        if (seen(reachOf(source), request)) shown.push_back({&one, source, double(glm::length(source.origin))});
    }
    // The nearest ones where there are too many; then by id, so that the scene's order does not matter.
    const auto nearer = [](const Shown& a, const Shown& b) {
        return std::pair{a.away, a.placed->id} < std::pair{b.away, b.placed->id};
    };
    if (shown.size() > MOST_PARTICLE_SOURCES) {
        std::ranges::sort(shown, nearer);
        shown.resize(MOST_PARTICLE_SOURCES);
    }
    std::ranges::sort(shown, {}, [](const Shown& s) { return s.placed->id; });

    double wanted = 0;
    for (const Shown& s : shown)
        wanted += steady(s.placed->what);
    std::int64_t every = 1; // one in so many is drawn, the same ones from frame to frame
    while (wanted > double(request.most) * double(every))
        every *= 2;

    Particles result;
    std::vector<std::pair<float, glsl::Particle>> order; // view depth, m
    for (const Shown& s : shown) {
        const auto number = std::uint32_t(result.sources.size());
        result.sources.push_back(s.source);
        const double life = double(s.source.life), rate = steady(s.placed->what) / life;
        const double time = ownTime(*s.placed, request.time);
        const auto newest = std::int64_t(std::floor(time * rate / double(every))) * every;
        for (std::int64_t birth = newest;; birth -= every) {
            const double age = time - double(birth) / rate;
            if (age >= life) break;
            const glsl::Particle particle{number, std::uint32_t(birth) * 2654435761u + io::number(s.placed->id), float(std::max(age, 0.0))};
            const glm::vec3 centre = glsl::particleCentre(s.source, particle.seed, particle.age);
            order.emplace_back(glm::dot(centre, glm::vec3{request.eye.forward}), particle);
        }
    }
    std::ranges::sort(order, [](const auto& a, const auto& b) {
        if (a.first != b.first) return a.first > b.first;
        return std::pair{a.second.source, a.second.seed} < std::pair{b.second.source, b.second.seed};
    });
    result.drawn.reserve(order.size());
    for (const auto& [depth, particle] : order)
        result.drawn.push_back(particle);
    return result;
}

} // namespace renderer
