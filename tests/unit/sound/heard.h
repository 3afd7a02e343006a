// A project with sounds of known shape, a scene in which they stand, and what comes out of the loopback device.
#pragma once

#include "app/sound/sound.h"

#include <functional>
#include <vector>

namespace tests {

struct Loudness {
    double left = 0, right = 0; // root mean squares
    double all() const;
};
double decibels(double level, double of);

class SoundWorld {
public:
    SoundWorld();
    ~SoundWorld();

    using Wave = std::function<float(double seconds)>;
    // A file of the project, 16-bit unless it ends in .ogg.
    void write(const std::string& file, double seconds, const Wave& wave, int rate = 44100) const;
    void writeText(const std::string& file, const std::string& text) const;

    io::TemplateId addTemplate(const io::Template& value);
    io::ObjectId add(io::TemplateId what, const glm::dvec3& at);
    void move(io::ObjectId id, const glm::dvec3& to);
    void remove(io::ObjectId id);
    void edit(io::TemplateId id, const std::function<void(io::Template&)>& change);
    void setEnvironment(const std::function<void(io::Environment&)>& change);

    // Lets the sound go on for a while; what the last `measured` seconds were like.
    Loudness listen(app::Sound& sound, const app::Listener& listener, double seconds = 2.5, double measured = 0.5);
    std::vector<float> last; // stereo, of the last listen()

    io::Scene scene;
    std::filesystem::path folder;

private:
    io::Changes m_changes;
};

float tone(double seconds); // 440 Hz, half of full scale

} // namespace tests
