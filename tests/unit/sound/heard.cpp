#include "tests/unit/sound/heard.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sndfile.h>
#include <unistd.h>

namespace tests {
namespace fs = std::filesystem;

double Loudness::all() const
{
    return std::sqrt(left * left + right * right);
}

double decibels(double level, double of)
{
    return 20 * std::log10(std::max(level, 1e-9) / of);
}

float tone(double seconds)
{
    return 0.5f * float(std::sin(2 * std::numbers::pi * 440 * seconds));
}

SoundWorld::SoundWorld()
{
    std::string name = (fs::temp_directory_path() / "wold_sound_XXXXXX").string();
    folder = mkdtemp(name.data());
    fs::create_directories(folder / "sounds");
    m_changes.everything = true;
}

SoundWorld::~SoundWorld()
{
    std::error_code fault;
    fs::remove_all(folder, fault);
}

void SoundWorld::write(const std::string& file, double seconds, const Wave& wave, int rate) const
{
    const bool ogg = file.ends_with(".ogg"), flac = file.ends_with(".flac");
    SF_INFO info{.samplerate = rate, .channels = 1, .format = ogg ? SF_FORMAT_OGG | SF_FORMAT_VORBIS : (flac ? SF_FORMAT_FLAC : SF_FORMAT_WAV) | SF_FORMAT_PCM_16};
    SNDFILE* const out = sf_open((folder / file).c_str(), SFM_WRITE, &info);
    std::vector<float> samples(std::size_t(seconds * rate));
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] = wave(double(i) / rate);
    for (std::size_t i = 0; i < samples.size(); i += 65536)
        sf_writef_float(out, samples.data() + i, sf_count_t(std::min<std::size_t>(65536, samples.size() - i)));
    sf_close(out);
}

void SoundWorld::writeText(const std::string& file, const std::string& text) const
{
    std::ofstream{folder / file, std::ios::binary} << text;
}

io::TemplateId SoundWorld::addTemplate(const io::Template& value)
{
    const io::TemplateId id = scene.templateSlot(value.name);
    scene.exchange(id, value);
    m_changes.templates.push_back(id);
    return id;
}

io::ObjectId SoundWorld::add(io::TemplateId what, const glm::dvec3& at)
{
    const io::ObjectId id = scene.freshId();
    scene.exchange(id, io::Object{.id = id, .templateId = what, .transform = {.position = at}});
    m_changes.objects.push_back(id);
    return id;
}

void SoundWorld::move(io::ObjectId id, const glm::dvec3& to)
{
    io::Object object = scene.at(id);
    object.transform.position = to;
    scene.exchange(id, object);
    m_changes.objects.push_back(id);
}

void SoundWorld::remove(io::ObjectId id)
{
    scene.exchange(id, std::nullopt);
    m_changes.objects.push_back(id);
}

void SoundWorld::edit(io::TemplateId id, const std::function<void(io::Template&)>& change)
{
    io::Template value = *scene.find(id);
    change(value);
    scene.exchange(id, value);
    m_changes.templates.push_back(id);
}

void SoundWorld::setEnvironment(const std::function<void(io::Environment&)>& change)
{
    io::Environment value = scene.environment();
    change(value);
    scene.exchange(value);
    m_changes.environment = true;
}

Loudness SoundWorld::listen(app::Sound& sound, const app::Listener& listener, double seconds, double measured)
{
    constexpr int kFrames = app::Sound::kLoopbackRate / 50; // 20 ms
    last.clear();
    std::vector<float> block(std::size_t(kFrames) * 2);
    for (double time = 0; time < seconds; time += 0.02) {
        sound.update({.scene = scene, .changes = m_changes, .listener = listener, .seconds = 0.02});
        m_changes = {};
        sound.render(block);
        last.insert(last.end(), block.begin(), block.end());
    }
    const std::size_t from = last.size() - std::min(last.size(), std::size_t(measured * app::Sound::kLoopbackRate) * 2);
    double left = 0, right = 0;
    for (std::size_t i = from; i + 1 < last.size(); i += 2) {
        left += double(last[i]) * last[i];
        right += double(last[i + 1]) * last[i + 1];
    }
    const double frames = double(last.size() - from) / 2;
    return {std::sqrt(left / frames), std::sqrt(right / frames)};
}

} // namespace tests
