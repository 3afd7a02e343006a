#include "app/sound/sound_check.h"

#include "app/sound/sound_file.h"
#include "io/base/paths.h"
#include "io/base/text_place.h"

#include <map>

namespace app {
namespace {

namespace fs = std::filesystem;

struct Naming {
    fs::path file; // that names the sound
    std::string key;
};

std::string faultOf(const fs::path& project, const std::string& file)
{
    const io::Result<fs::path> path = io::insideFolder(project, file);
    if (!path) return path.error().what;
    io::Result<SoundFile> opened = SoundFile::open(*path);
    if (!opened) return opened.error().what;
    std::int16_t first[2];
    return opened->read(first, 2) == 0 ? "holds no sound; it may be cut off" : "";
}

} // namespace

void checkSounds(const io::Scene& scene, const fs::path& project, const std::string& sceneFile, io::Complaints& complaints)
{
    std::map<std::string, Naming> named; // by the sound; who names it first
    const auto add = [&](const std::string& sound, const fs::path& by, const char* key) {
        if (!sound.empty()) named.emplace(sound, Naming{project / by, key});
    };
    for (const io::Scene::TemplateSlot& slot : scene.templates()) {
        if (!slot.value) continue;
        const fs::path by = fs::path{"templates"} / (slot.name + ".json");
        add(slot.value->sound.file, by, "sound.file");
        add(slot.value->steps, by, "steps");
        for (const io::TriggerAction& action : slot.value->trigger.actions)
            if (action.action == io::TriggerDo::PlaySound) add(action.what, by, "trigger.actions");
    }
    for (const io::TerrainLayer& layer : scene.terrain().layers)
        add(layer.steps, sceneFile, "terrain.layers");
    for (const auto& [sound, by] : named)
        if (const std::string fault = faultOf(project, sound); !fault.empty())
            complaints.push_back({io::Severity::Error, io::placeOf(by.file, sound), by.key + ": " + sound + ": " + fault});
}

} // namespace app
