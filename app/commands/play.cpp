// wold play: the game without the editor, in a window (edit.cpp). With --input the same steps on every machine, without one.
#include "app/commands/commands.h"
#include "app/opened.h"
#include "app/play/session.h"
#include "app/replay.h"
#include "app/report.h"
#include "io/files/atomic_file.h"

#include <chrono>

namespace app {
namespace {

// Feeds recorded events to the player, each in a step of its own.
class Hands {
public:
    explicit Hands(std::vector<Step> steps) : m_steps{std::move(steps)} {}

    // What is done in the next step; false when nothing is left.
    bool next()
    {
        turned = {0, 0};
        while (m_next < m_steps.size()) {
            const Action& action = m_steps[m_next].action;
            if (const auto* wait = std::get_if<step::Wait>(&action); wait && m_waited++ < wait->frames) return true;
            m_waited = 0;
            ++m_next;
            if (take(action)) return true;
        }
        return false;
    }

    play::Held held;
    glm::dvec2 turned{0};

private:
    void hold(const std::string& name, double share)
    {
        if (share > 0) held[name] = share;
        else held.erase(name);
    }
    bool take(const Action& action) // whether it takes a step
    {
        if (const auto* key = std::get_if<step::Key>(&action)) return hold(nameOfKey(key->code), key->down), true;
        if (const auto* button = std::get_if<step::Button>(&action)) return hold("mouse " + std::to_string(button->button + 1), button->down), true;
        if (const auto* pad = std::get_if<step::Pad>(&action)) return hold(pad->name, pad->share), true;
        if (const auto* move = std::get_if<step::Move>(&action)) {
            const glm::dvec2 to = glm::mix(move->from.pixel, move->to.pixel, move->share);
            if (m_pointerKnown) turned = (m_pointer - to) * play::kTurnOfPixel;
            m_pointer = to;
            return m_pointerKnown = true;
        }
        return false;
    }

    std::vector<Step> m_steps;
    std::size_t m_next = 0;
    int m_waited = 0;
    glm::dvec2 m_pointer{0};
    bool m_pointerKnown = false;
};

using Clock = std::chrono::steady_clock;

double msSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

} // namespace

int play(const Options& options)
{
    if (options.input.empty()) return playInWindow(options);
    auto steps = readReplay(options.input);
    if (!steps) return fault(steps.error());
    auto opened = openAsAsked(options);
    if (const int* code = std::get_if<int>(&opened)) return *code;
    const editor::Document& document = *std::get<Opened>(opened).document;
    const auto camera = cameraFor(options, document);
    if (!camera) return fault(camera.error());

    const Clock::time_point start = Clock::now();
    const bool fromMarker = !options.view && options.camera.empty(); // as in the window
    play::Session session{document.scene(), document.assets(), *camera, fromMarker};
    const double entering = msSince(start);
    play::Controls controls{document.project().controls};
    Hands hands{*std::move(steps)};
    std::string trace;
    double longest = 0;
    const Clock::time_point first = Clock::now();
    for (int i = 0; options.frames == 0 || i < options.frames; ++i) {
        if (!hands.next() && options.frames == 0) break;
        const Clock::time_point before = Clock::now();
        const play::Wish wish = controls.wish(hands.held, hands.turned);
        session.step(wish, controls.pressed("eye"));
        longest = std::max(longest, msSince(before));
        if (!options.trace.empty()) trace += traceLine(session);
    }
    const double all = msSince(first);
    if (!options.trace.empty())
        if (const io::Status written = io::writeFile(options.trace, trace); !written) return fault(written.error());
    const double count = std::max(1.0, double(session.steps()));
    const io::Status written = writeFigures(options.json, io::Value::Object{{"steps", double(session.steps())}, {"enter_ms", entering},
                                                                            {"step_ms", all / count}, {"longest_step_ms", longest}});
    return written ? 0 : fault(written.error());
}

} // namespace app
