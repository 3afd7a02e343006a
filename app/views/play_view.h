// PlayView: walking through a world in the window. The editor lies behind it and is as it was when it comes back.
#pragma once

#include "app/pads.h"
#include "app/play/shape_lines.h"
#include "app/play/step_clock.h"
#include "app/sound/sound.h"
#include "app/views/view.h"
#include "editor/cameras.h"
#include "editor/picker.h"
#include "editor/play_changes.h"
#include "editor/sound_settings.h"
#include "renderer/renderer.h"

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace app {

struct PlayBegin {
    const editor::Document* document = nullptr; // outlives the play, and does not change meanwhile
    const editor::Picker* picker = nullptr;     // of that: what stands before a sound muffles it
    editor::Cameras* cameras = nullptr;         // begins where the editor's looks, and is one of them itself
    bool fromMarker = false;   // begins at the world's start marker, if it has one
    bool repeatable = false;   // no sound, and pictures in full size however long they take
    bool alone = false;        // Escape ends the program: there is no editor to come back to
    renderer::Settings drawing;
    editor::SoundSettings sound;
};

class PlayView final : public View {
public:
    PlayView(renderer::Renderer& renderer, const Pads& pads) : m_renderer{renderer}, m_pads{pads} {}

    void begin(const PlayBegin& begin); // before it is woken
    std::vector<editor::PlayChange> takeLeft() { return std::exchange(m_left, {}); } // by the last play, once
    bool wantsBack() const { return m_wantsBack; }

    io::Status init() override { return {}; }
    void run(double seconds) override;
    void runImGui() override;
    void stop() override; // the renderer shows the document's world again

private:
    struct Trod { // a place that grass is still getting up from
        glm::dvec3 at{0};
        double seconds = 0; // since
    };
    struct Message {
        std::string text;
        double seconds = 0; // that it stays
    };
    struct Coming { // a look on its way
        io::Environment from, to;
        double seconds = 0, passed = 0;
    };
    play::Held held() const;
    void step(const play::Wish& wish);
    void passLight();
    void take(const play::Event& event);
    void hear(double seconds);
    std::vector<renderer::Presser> pressers() const;
    glm::ivec2 pictureSize() const;
    std::span<const renderer::Line> lines();
    void moveBetween();
    void drawOverlay() const;

    renderer::Renderer& m_renderer;
    const Pads& m_pads;
    PlayBegin m_begin;
    std::optional<play::Session> m_session;
    play::Controls m_controls;
    std::optional<Sound> m_sound;
    io::Changes m_heard; // changes that the sound has not been told
    std::optional<io::Environment> m_look; // in place of the scene's, once one came
    std::optional<io::Environment> m_now;  // the same, at the hour that it has become; none: as the scene's
    double m_hours = 0;                    // that the day has gone on since that look, or the beginning
    std::optional<Coming> m_coming;
    std::deque<Trod> m_trod;
    std::deque<Message> m_messages;
    std::vector<editor::PlayChange> m_left;
    double m_seconds = 0; // of this frame
    play::StepClock m_clock;
    double m_time = 0;
    double m_scale = 1; // of the picture's sides, to keep up
    double m_walked = 0;    // m, since the last frame
    struct Due {
        std::string file;
        glm::dvec3 at{0};
    };
    std::vector<Due> m_due; // sounds of this frame's steps: they wait until it is known where the ear is
    std::optional<play::ShapeLines> m_shapes; // while they are shown
    std::vector<renderer::Line> m_lines;
    std::vector<io::Moved> m_between; // things that are drawn between the last two steps
    bool m_overlay = false, m_wantsBack = false;
};

} // namespace app
