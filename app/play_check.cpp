#include "app/play_check.h"

#include "app/pads.h"
#include "editor/key_names.h"
#include "io/base/text_place.h"
#include "io/files/usual_controls.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <set>

namespace app {
namespace {

class Check {
public:
    Check(const io::World& world, const io::KeptLooks& kept) : m_world{world}, m_kept{kept} {}

    io::Complaints run()
    {
        for (const io::Control& control : m_world.project.controls)
            ofControl(control);
        for (const io::Object& object : m_world.scene.objects()) {
            m_used.insert(m_world.scene.templateName(object.templateId));
            if (!object.name.empty()) m_names.insert(object.name);
        }
        for (const io::ScatterLayer& layer : m_world.scene.scatterLayers())
            for (const io::Species& species : layer.species)
                m_used.insert(species.templateName);
        for (const io::Scene::TemplateSlot& slot : m_world.scene.templates())
            if (slot.value && slot.value->trigger.shape != io::TriggerShape::None && m_used.contains(slot.name))
                for (const io::TriggerAction& action : slot.value->trigger.actions)
                    ofTrigger("templates/" + slot.name + ".json", slot.name, action);
        ofStarts();
        return std::move(m_found);
    }

private:
    // `text` is what the line holds that is meant.
    void say(const std::string& file, const std::string& text, std::string what)
    {
        m_found.push_back({io::Severity::Warning, io::placeOf(m_world.project.folder / file, text), std::move(what)});
    }

    void ofControl(const io::Control& control)
    {
        const auto actions = io::playActions();
        if (std::ranges::find(actions, control.action) == actions.end())
            say("project.json", control.action, fmt::format("controls: there is no action \"{}\"; those are {}", control.action, fmt::join(actions, ", ")));
        else if (!control.by.empty() && !isControl(control.by))
            say("project.json", control.by, fmt::format("controls: {}: there is no \"{}\"; a key is named as \"W\" or \"Space\", a button as \"mouse 1\" or \"pad A\", a stick as \"pad left +x\"",
                                            control.action, control.by));
    }

    static bool isControl(std::string_view name)
    {
        if (name.starts_with("mouse ")) {
            int button = 0;
            const char* end = name.data() + name.size();
            return std::from_chars(name.data() + 6, end, button).ptr == end && button >= 1 && button <= 5;
        }
        if (name.starts_with("pad ")) {
            const auto pads = padControls();
            return std::ranges::find(pads, name) != pads.end();
        }
        return editor::keyNamed(name).has_value();
    }

    void ofTrigger(const std::string& file, const std::string& name, const io::TriggerAction& action)
    {
        const auto missing = [&](const char* what) {
            say(file, action.what, fmt::format("trigger.actions: {} names {} \"{}\", which {} does not have", name, what, action.what, m_world.entry.file));
        };
        switch (action.action) {
        case io::TriggerDo::Teleport:
            if (!m_world.scene.findCamera(action.what)) missing("the camera");
            break;
        case io::TriggerDo::Show:
        case io::TriggerDo::Hide:
            if (!m_names.contains(action.what)) missing("the object or group");
            break;
        case io::TriggerDo::ComeToLook: {
            io::Complaints ignored;
            if (const auto look = io::lookNamed(action.what, m_world.scene.environment(), m_kept, ignored); !look)
                say(file, action.what, fmt::format("trigger.actions: {} names the look \"{}\": {}", name, action.what, look.error().text()));
            break;
        }
        case io::TriggerDo::PlaySound:
        case io::TriggerDo::Message: break;
        }
    }

    void ofStarts()
    {
        const io::Scene& scene = m_world.scene;
        std::vector<const io::Object*> starts;
        for (const io::Object& object : scene.objects())
            if (const io::Template* value = scene.find(object.templateId); value && value->player.start) starts.push_back(&object);
        if (starts.empty() || scene.terrain().heightMap.empty()) return;
        io::Complaints said; // by who reads the ground
        const auto map = scene.heights() ? scene.heights() : io::readHeights(m_world, scene.terrain(), said);
        if (!map) return;
        const glm::dvec2 low = map->origin, high = map->origin + glm::dvec2{map->size - 1} * double(map->metresPerTexel);
        for (const io::Object* start : starts) {
            const glm::dvec2 at{start->transform.position.x, start->transform.position.z};
            if (glm::any(glm::lessThan(at, low)) || glm::any(glm::greaterThan(at, high)))
                say(m_world.entry.file, std::string{scene.templateName(start->templateId)},
                    fmt::format("object {}: the start at {:.1f}, {:.1f} lies beside the ground; one begins at the nearest place on it", number(start->id), at.x, at.y));
        }
    }

    const io::World& m_world;
    const io::KeptLooks& m_kept;
    std::set<std::string_view> m_names, m_used; // of objects and groups; of templates that this scene shows
    io::Complaints m_found;
};

} // namespace

io::Complaints checkPlay(const io::World& world, const io::KeptLooks& kept)
{
    return Check{world, kept}.run();
}

} // namespace app
