#include "app/player.h"

#include "editor/ui_map.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

namespace app {
namespace {

constexpr int kPatience = 120; // frames that a widget may take to appear

std::optional<glm::dvec2> find(const Place& place)
{
    if (!place.isWidget()) return place.pixel;
    const io::Value map = editor::uiMap();
    const auto matches = [](const std::string& wanted, const io::Value* value) {
        return wanted.empty() || (value && value->asString() && *value->asString() == wanted);
    };
    for (const io::Value& item : *map.asArray()) {
        if (!matches(place.panel, item.find("panel")) || !matches(place.label, item.find("label")) ||
            !matches(place.kind, item.find("kind")))
            continue;
        const io::Value::Array& rect = *item.find("rect")->asArray();
        const auto at = [&](std::size_t i) { return *rect[i].asNumber(); };
        return glm::floor(glm::dvec2{at(0) + at(2) / 2, at(1) + at(3) / 2}) + place.pixel;
    }
    return std::nullopt;
}

void setKey(ImGuiIO& io, int code, bool down)
{
    const auto held = [&](int left, int right) { return io.KeysDown[left] || io.KeysDown[right]; };
    io.KeysDown[code] = down;
    io.KeyCtrl = held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    io.KeyShift = held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    io.KeyAlt = held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
}

} // namespace

Player::Player(std::vector<Step> steps, std::string name, Stage stage)
    : m_steps{std::move(steps)}, m_name{std::move(name)}, m_stage{std::move(stage)}
{
}

io::Result<bool> Player::feed(ImGuiIO& io)
{
    while (m_next < m_steps.size()) {
        const Step& step = m_steps[m_next];
        const auto progress = play(step, io);
        if (!progress) return atLine(step, progress.error());
        if (*progress == Progress::Waiting) return ++m_waited, true;
        ++m_next;
        m_waited = 0;
        if (*progress == Progress::FrameDone) return true;
    }
    return false;
}

io::Error Player::atLine(const Step& step, const io::Error& error) const
{
    return {fmt::format("{}:{}", m_name, step.line), error.text()};
}

io::Result<Player::Progress> Player::move(const step::Move& move, ImGuiIO& io)
{
    const bool onTheWay = move.share < 1;
    const auto to = find(move.to), from = onTheWay ? find(move.from) : to;
    if (to && from) {
        const glm::dvec2 at = glm::mix(*from, *to, move.share);
        io.MousePos = {float(at.x) / io.DisplayFramebufferScale.x, float(at.y) / io.DisplayFramebufferScale.y};
        return Progress::FrameDone;
    }
    if (m_waited < kPatience) return Progress::Waiting;
    const Place& missing = to ? move.from : move.to;
    return io::Error{"",
                     fmt::format("no widget with panel \"{}\", label \"{}\" is visible; --ui-map lists those that are",
                                 missing.panel, missing.label)};
}

io::Result<Player::Progress> Player::play(const Step& step, ImGuiIO& io)
{
    if (const auto* one = std::get_if<step::Move>(&step.action)) return move(*one, io);
    if (const auto* one = std::get_if<step::Button>(&step.action))
        return io.MouseDown[one->button] = one->down, Progress::FrameDone;
    if (const auto* one = std::get_if<step::Key>(&step.action))
        return setKey(io, one->code, one->down), Progress::FrameDone;
    if (const auto* one = std::get_if<step::Text>(&step.action))
        return io.AddInputCharactersUTF8(one->text.c_str()), Progress::FrameDone;
    if (const auto* one = std::get_if<step::Pad>(&step.action))
        return m_stage.pad(*one), Progress::FrameDone;
    if (const auto* one = std::get_if<step::Wheel>(&step.action)) {
        io.MouseWheelH += float(one->by.x);
        io.MouseWheel += float(one->by.y);
        return Progress::FrameDone;
    }
    if (const auto* one = std::get_if<step::Wait>(&step.action))
        return m_waited < one->frames ? Progress::Waiting : Progress::NextStep;
    if (const auto* one = std::get_if<step::Resize>(&step.action))
        return m_stage.resize(one->size), Progress::FrameDone;

    const auto* shot = std::get_if<step::Shot>(&step.action);
    const io::Status done = shot ? m_stage.shot(shot->file) : m_stage.uiMap(std::get<step::UiMap>(step.action).file);
    if (!done) return done.error();
    return Progress::NextStep;
}

} // namespace app
