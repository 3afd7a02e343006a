#include "app/views/play_view.h"

#include "app/views/world_sound.h"
#include "editor/held_controls.h"
#include "editor/keys.h"
#include "editor/text.h"
#include "io/base/log.h"
#include "io/base/paths.h"
#include "io/files/kept_looks.h"
#include "io/scene/environment_mix.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace app {
namespace {

constexpr double kFastEnough = 1.0 / 24; // s a frame, from which the picture is drawn coarser
constexpr double kCoarsest = 0.35;
constexpr double kTrodApart = 0.35;   // m
constexpr double kStaysDown = 0.5;    // s until grass has got up by 1 - 1/e
constexpr double kSwings = 7;         // rad/s, of grass that springs back
constexpr double kHintStays = 5;      // s
constexpr glm::vec4 kShapeColours[]{{0.35f, 0.8f, 1, 0.8f}, {1, 0.6f, 0.15f, 0.95f}, {0.4f, 1, 0.4f, 0.9f}}; // sRGB, of play::LineOf

} // namespace

void PlayView::begin(const PlayBegin& begin)
{
    m_begin = begin;
    m_wantsBack = false;
    m_time = m_seconds = 0;
    m_clock = {};
    m_now.reset();
    m_look.reset();
    m_hours = 0;
    m_coming.reset();
    m_trod.clear();
    m_shapes.reset();
    m_between.clear();
    m_messages = {{editor::tr(begin.alone ? "play.hint_alone" : "play.hint"), kHintStays}};
    m_controls = play::Controls{begin.document->project().controls};
    m_session.emplace(begin.document->scene(), begin.document->assets(), begin.cameras->named(editor::kEditCamera), begin.fromMarker);
    m_walked = 0;
    m_due.clear();
    m_heard = {.everything = true};
    if (begin.repeatable) return;
    m_sound.emplace(begin.document->project().folder);
    setLevels(*m_sound, begin.sound);
    if (begin.picker) m_sound->setBlocked(blockedBy(*begin.picker, [this](io::ObjectId id) { return m_session && m_session->changed(id); }));
}

void PlayView::run(double seconds)
{
    m_seconds = seconds;
}

play::Held PlayView::held() const
{
    play::Held held = editor::heldKeys();
    held.merge(m_pads.held());
    return held;
}

void PlayView::step(const play::Wish& wish)
{
    m_session->step(wish, m_controls.pressed("eye"));
    m_walked += m_session->walked();
    for (const play::Event& event : m_session->events())
        take(event);
    for (Trod& trod : m_trod)
        trod.seconds += play::kStep;
    while (!m_trod.empty() && m_trod.front().seconds > 6 * kStaysDown)
        m_trod.pop_front();
    const play::Walker& walker = m_session->walker();
    if (walker.grounded() && (m_trod.empty() || glm::distance(m_trod.back().at, walker.feet()) > kTrodApart)) m_trod.push_back({walker.feet()});
    passLight();
}

// What light does by itself: a look comes, and the day goes on from it.
void PlayView::passLight()
{
    if (m_coming) {
        m_coming->passed += play::kStep;
        const double share = m_coming->seconds <= 0 ? 1 : std::min(m_coming->passed / m_coming->seconds, 1.0);
        m_look = io::mixed(m_coming->from, m_coming->to, share);
        if (share >= 1) m_coming.reset();
    }
    const io::Environment& own = m_look ? *m_look : m_session->scene().environment();
    m_now = m_look;
    if (!own.dayRuns) return;
    m_hours += play::kStep * double(own.daySpeed) / 3600;
    m_now = io::hoursLater(own, m_hours);
}

void PlayView::take(const play::Event& event)
{
    const io::Environment& now = m_now ? *m_now : m_session->scene().environment();
    if (event.kind == play::Event::Kind::Message) {
        m_messages.push_back({event.what, double(event.seconds)});
    } else if (event.kind == play::Event::Kind::Sound) {
        if (m_sound) m_due.push_back({event.what, event.at});
    } else if (event.kind == play::Event::Kind::Look) {
        io::Complaints ignored;
        io::Result<io::Environment> look = io::lookNamed(event.what, now, io::KeptLooks{io::looksFolder()}, ignored);
        if (look) m_coming = Coming{now, *std::move(look), double(event.seconds)}, m_look = m_coming->from, m_hours = 0;
        else io::log::warning("a trigger's look {}: {}", event.what, look.error().text());
    }
}

void PlayView::hear(double seconds)
{
    if (!m_sound) return;
    const play::Walker& walker = m_session->walker();
    const io::Camera ear = m_session->camera();
    m_sound->update({.scene = m_session->scene(),
                     .changes = m_heard,
                     .listener = {ear.eye, ear.yaw, ear.pitch},
                     .seconds = seconds,
                     .now = m_now ? &*m_now : nullptr});
    m_heard = {};
    for (const Due& due : std::exchange(m_due, {}))
        m_sound->play(due.file, due.at, 30);
    m_sound->walk(m_session->scene(), {.at = walker.feet(), .walked = std::exchange(m_walked, 0), .speed = float(glm::length(walker.velocity())), .on = m_session->standsOn()});
    for (const io::Complaint& notice : m_sound->takeNotices())
        io::log::warning("{}: {}", notice.where, notice.what);
}

// Grass lies under the feet; where they were it swings back up.
std::vector<renderer::Presser> PlayView::pressers() const
{
    std::vector<renderer::Presser> pressers;
    const play::Walker& walker = m_session->walker();
    const auto radius = float(double(walker.likes().radius) + 0.45);
    pressers.push_back({walker.feet(), radius, walker.flying() ? 0.0f : 1.0f});
    for (auto trod = m_trod.rbegin(); trod != m_trod.rend() && pressers.size() < renderer::kMostPressers; ++trod)
        if (glm::distance(trod->at, walker.feet()) > kTrodApart)
            pressers.push_back({trod->at, radius, float(std::exp(-trod->seconds / kStaysDown) * std::cos(trod->seconds * kSwings))});
    return pressers;
}

glm::ivec2 PlayView::pictureSize() const
{
    const ImGuiIO& io = ImGui::GetIO();
    const glm::dvec2 whole{double(io.DisplaySize.x) * double(io.DisplayFramebufferScale.x), double(io.DisplaySize.y) * double(io.DisplayFramebufferScale.y)};
    return glm::max(glm::ivec2{whole * m_scale}, glm::ivec2{16});
}

void PlayView::runImGui()
{
    if (editor::pressed(editor::Key::Escape)) m_wantsBack = true;
    if (editor::pressed(editor::Key::F3)) m_overlay = !m_overlay;
    if (editor::pressed(editor::Key::F4)) {
        if (m_shapes) m_shapes.reset();
        else m_shapes.emplace();
    }
    const ImGuiIO& io = ImGui::GetIO();
    const play::Held now = held();
    const glm::dvec2 turned = glm::dvec2{-double(io.MouseDelta.x), -double(io.MouseDelta.y)} * play::kTurnOfPixel;
    m_clock.pass(m_seconds, turned, [&](const glm::dvec2& turn) { step(m_controls.wish(now, turn)); });
    m_time += m_seconds;
    for (Message& message : m_messages)
        message.seconds -= m_seconds;
    std::erase_if(m_messages, [](const Message& message) { return message.seconds <= 0; });

    io::Changes changes = m_session->takeChanges();
    if (!changes.none()) m_renderer.update(m_session->scene(), m_begin.document->assets(), changes);
    m_heard.add(changes);
    hear(m_seconds);
    moveBetween();

    const std::vector<renderer::Presser> pressed = pressers();
    renderer::FrameInput in;
    in.camera = m_begin.cameras->look(editor::kPlayCamera, m_session->camera(m_clock.share()));
    in.size = pictureSize();
    in.settings = m_begin.drawing;
    in.time = m_time;
    in.environment = m_now;
    in.pressers = pressed;
    in.lines = lines();
    in.markers = false;
    in.ids = false;
    const renderer::Picture picture = m_renderer.render(in);
    ImGui::GetBackgroundDrawList()->AddImage(reinterpret_cast<ImTextureID>(picture.texture), {0, 0}, io.DisplaySize, {0, 1}, {1, 0});
    drawOverlay();
    if (!m_begin.repeatable && m_seconds > 0) m_scale = std::clamp(m_scale * std::clamp(std::sqrt(kFastEnough / m_seconds), 0.85, 1.04), kCoarsest, 1.0);
}

// Bodies are where the camera sees them from: between the last two steps. What has come to rest goes to where it is.
void PlayView::moveBetween()
{
    std::vector<io::Moved> rested;
    for (const io::Moved& thing : m_between)
        if (const io::Object* object = m_session->scene().find(thing.id)) rested.push_back({thing.id, object->transform});
    m_renderer.move(rested);
    m_between = m_session->between(m_clock.share());
    m_renderer.move(m_between);
}

// What can be run into, what moves by itself, and the player.
std::span<const renderer::Line> PlayView::lines()
{
    m_lines.clear();
    if (!m_shapes) return m_lines;
    for (const play::ShapeLine& line : m_shapes->around(*m_session))
        m_lines.push_back({line.from, line.to, kShapeColours[std::size_t(line.of)]});
    return m_lines;
}

void PlayView::drawOverlay() const
{
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const auto line = [&](float x, float y, const std::string& text) {
        list.AddText({x + 1, y + 1}, IM_COL32(0, 0, 0, 200), text.c_str());
        list.AddText({x, y}, IM_COL32(255, 255, 255, 235), text.c_str());
    };
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float row = ImGui::GetTextLineHeight() * 1.3f;
    for (std::size_t i = 0; i < m_messages.size(); ++i)
        line(size.x / 2 - ImGui::CalcTextSize(m_messages[i].text.c_str()).x / 2, size.y * 0.82f + row * float(i), m_messages[i].text);
    if (!m_overlay) return;
    const play::Walker& walker = m_session->walker();
    const glm::dvec3 &at = walker.feet(), &v = walker.velocity(), &n = walker.groundNormal();
    float y = row;
    const auto add = [&](const std::string& text) {
        line(row, y, text);
        y += row;
    };
    const char* state = walker.flying() ? "play.flies" : walker.swimming() ? "play.swims" : walker.grounded() ? "play.stands" : "play.falls";
    add(fmt::format("{}  {:.2f}  {:.2f}  {:.2f} m  ({})", editor::tr("play.place"), at.x, at.y, at.z, editor::tr(state)));
    add(fmt::format("{}  {:.2f}  {:.2f}  {:.2f}  ({:.2f} m/s)", editor::tr("play.velocity"), v.x, v.y, v.z, glm::length(v)));
    add(fmt::format("{}  {:.2f}  {:.2f}  {:.2f}  ({:.0f}\xc2\xb0)", editor::tr("play.normal"), n.x, n.y, n.z, glm::degrees(std::acos(std::clamp(n.y, -1.0, 1.0)))));
    for (const play::Touched& touched : walker.touched()) {
        const io::Object* object = m_session->scene().find(touched.id);
        const std::string name = touched.id == io::ObjectId::None ? editor::tr("play.ground")
                                 : object ? std::string{m_session->scene().templateName(object->templateId)}
                                          : std::to_string(io::number(touched.id));
        add(fmt::format("{}  {}  {:.2f} m/s", editor::tr("play.touches"), name, touched.speed));
    }
}

void PlayView::stop()
{
    if (!m_session) return;
    m_sound.reset();
    for (auto& [before, after] : m_session->left())
        m_left.push_back({before, after});
    const io::Changes back = m_session->differences();
    if (!back.none()) m_renderer.update(m_begin.document->scene(), m_begin.document->assets(), back);
    m_session.reset();
}

} // namespace app
