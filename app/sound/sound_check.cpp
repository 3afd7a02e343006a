#include "app/sound/sound_check.h"

#include "app/sound/sound_file.h"
#include "io/base/paths.h"

#include <map>

namespace app {

void checkSounds(const io::Scene& scene, const std::filesystem::path& project, io::Complaints& complaints)
{
    std::map<std::string, std::string> named; // file, and who names it first
    const auto add = [&](const std::string& file, const std::string& by) {
        if (!file.empty()) named.emplace(file, by);
    };
    for (const io::Scene::TemplateSlot& slot : scene.templates()) {
        if (!slot.value) continue;
        add(slot.value->sound.file, "template " + slot.name);
        add(slot.value->steps, "steps of template " + slot.name);
        for (const io::TriggerAction& action : slot.value->trigger.actions)
            if (action.action == io::TriggerDo::PlaySound) add(action.what, "trigger of template " + slot.name);
    }
    for (const io::TerrainLayer& layer : scene.terrain().layers)
        add(layer.steps, "steps of terrain layer " + layer.name);
    for (const auto& [file, by] : named) {
        const io::Result<std::filesystem::path> path = io::insideFolder(project, file);
        if (!path) {
            complaints.push_back({io::Severity::Error, file, path.error().what + " (" + by + ")"});
            continue;
        }
        io::Result<SoundFile> opened = SoundFile::open(*path);
        std::string fault = opened ? "" : opened.error().what;
        if (std::int16_t first[2]; opened && opened->read(first, 2) == 0) fault = "holds no sound; it may be cut off";
        if (!fault.empty()) complaints.push_back({io::Severity::Error, file, fault + " (" + by + ")"});
    }
}

} // namespace app
