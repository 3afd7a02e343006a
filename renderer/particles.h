// What gives off fire, smoke and dust: the mirror of a scene's sources, and the particles of one frame.
#pragma once

#include "io/scene/changes.h"
#include "io/scene/environment.h"
#include "io/scene/scene.h"
#include "renderer/eye.h"
#include "renderer/shaders/shared/particles.h"

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace renderer {

class ParticleSources {
public:
    // Costs what `changes` names; nothing where no template gives anything off.
    void update(const io::Scene& scene, const io::Changes& changes);

    struct Placed {
        io::ObjectId id = io::ObjectId::None;
        glm::dvec3 position{0}; // m, of the place where particles begin
        float scale = 1;
        io::ParticleSource what;
    };
    std::span<const Placed> placed() const { return m_placed; }

private:
    void readTemplate(const io::Scene& scene, io::TemplateId id);
    void place(const io::Scene& scene, io::ObjectId id);
    void remove(io::ObjectId id);
    bool gives(io::TemplateId id) const;

    std::vector<bool> m_gives; // by template's slot
    std::vector<Placed> m_placed;
    std::unordered_map<std::uint32_t, std::size_t> m_rowOf; // by object id
};

struct ParticleRequest {
    const Eye& eye;
    const std::optional<Volume>& volume; // without one, everybody's
    const io::Wind& wind;
    double time = 0;            // s
    std::size_t most = 10000;   // particles; sources are thinned evenly beyond that
};

struct Particles {
    std::vector<glsl::ParticleSource> sources; // in the order of their objects' ids
    std::vector<glsl::Particle> drawn;         // from back to front
};
Particles particlesOf(std::span<const ParticleSources::Placed> placed, const ParticleRequest& request);

} // namespace renderer
