// Which copies of templates let something be heard, and how loud each is at an ear.
#pragma once

#include "io/scene/scene.h"

#include <unordered_map>
#include <vector>

namespace app {

// A mirror of the scene that holds only objects and planted copies with a sound, densely: an ear asks all of them in a tenth of a millisecond for
// each hundred thousand.
class SoundSources {
public:
    struct Place {
        glm::dvec3 at{0}; // of the sound, in the world
        float radius = 0; // m
        io::ObjectId object = io::ObjectId::None;
        io::TemplateId what = io::TemplateId::None;
    };

    void follow(const io::Scene& scene, const io::Changes& changes); // the first time: all of it
    const std::vector<Place>& places() const { return m_places; }

private:
    void rebuild(const io::Scene& scene);
    void followObject(const io::Scene& scene, io::ObjectId id);
    void addPlanted(const io::Scene& scene);
    bool soundsIn(const io::Scene& scene, io::ScatterId layer) const;

    bool m_built = false;
    std::vector<bool> m_sounding; // by template slot: it had a sound when last looked at
    std::vector<Place> m_places;
    std::unordered_map<io::ObjectId, std::size_t> m_indexOf;
};

// By its curve, 0 from its radius on; without volume.
float levelAt(const io::SoundSource& source, double distance);
// Whether hour and weather let it be heard.
bool heardAt(const io::SoundSource& source, const io::Environment& environment);

} // namespace app
