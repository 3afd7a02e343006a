#include "app/views/world_sound.h"

#include <utility>
#include <vector>

namespace app {

void setLevels(Sound& sound, const editor::SoundSettings& settings)
{
    sound.setMasterVolume(settings.muted ? 0 : settings.master);
    for (std::size_t i = 0; i < settings.groups.size(); ++i)
        sound.setVolume(io::SoundGroup(i), settings.groups[i]);
}

SoundBlocked blockedBy(const editor::Picker& picker, std::function<bool(io::ObjectId)> gone)
{
    return [&picker, gone = std::move(gone)](const glm::dvec3& ear, const glm::dvec3& sound, io::ObjectId object) {
        constexpr double kClose = 0.5; // m; a thing does not muffle what sounds on its own surface
        const double distance = glm::distance(ear, sound);
        if (distance <= 2 * kClose) return false;
        const io::Ray ray{ear, (sound - ear) / distance};
        std::vector<io::ObjectId> skipped{object};
        constexpr std::size_t kMostSkipped = 8;
        while (const editor::PickHit hit = picker.pick(ray, {.skip = skipped, .maxDistance = distance - kClose})) {
            if (hit.id == io::ObjectId::None || !gone || !gone(hit.id) || skipped.size() > kMostSkipped) return true;
            skipped.push_back(hit.id);
        }
        return false;
    };
}

void WorldSound::begin(editor::Editor& editor)
{
    m_project = editor.document()->project().folder;
    m_settings = editor.sound;
    m_changes = {.everything = true};
    m_last = Clock::now();
    m_sound.emplace(m_project);
    setLevels(*m_sound, m_settings);
    m_sound->setBlocked(blockedBy(editor.picker()));
}

void WorldSound::end()
{
    m_sound.reset();
    m_changes = {.everything = true};
}

void WorldSound::update(editor::Editor& editor)
{
    const editor::Document* document = editor.document();
    if (!editor.sound.hear) m_said.clear();
    if (!editor.sound.hear || !document) return end();
    if (m_sound && m_project != document->project().folder) end();
    if (!m_sound) begin(editor);
    if (m_settings != editor.sound) {
        m_settings = editor.sound;
        setLevels(*m_sound, m_settings);
    }
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - std::exchange(m_last, now)).count();
    const io::Camera& camera = editor.viewport().camera.camera();
    const std::optional<io::Environment> moment = editor.live().shown(document->scene().environment());
    const io::Changes changes = std::exchange(m_changes, {});
    m_sound->update({.scene = document->scene(),
                     .changes = changes,
                     .listener = {camera.eye, camera.yaw, camera.pitch},
                     .seconds = seconds,
                     .now = moment ? &*moment : nullptr});
    for (const io::Complaint& notice : m_sound->takeNotices())
        if (m_said.insert(notice.where + notice.what).second) editor.toasts().add(io::log::Level::Warning, notice.where + ": " + notice.what);
}

} // namespace app
