// What light does by itself while a world is shown: the day runs, or one look turns into another. The scene keeps its own until
// that is over; then it becomes one step of undo.
#pragma once

#include "editor/document.h"

#include <optional>
#include <string>

namespace editor {

class LiveEnvironment {
public:
    void runDay(Document& document, bool on); // off: the scene takes the hour that it has become
    bool dayRuns() const { return m_dayRuns; }
    void turnInto(Document& document, io::Environment look, double seconds, std::string undoName); // 0 s: at once
    bool turning() const { return m_turning.has_value(); }
    std::string turningName() const { return m_turning ? m_turning->undoName : std::string{}; } // of the step that it becomes
    void stopTurning() { m_turning.reset(); } // the scene is seen as it is
    void settle(Document& document);          // a look that comes stays where it has come to, as a step
    void finish(Document& document);          // it is there at once, as a step
    bool moves() const { return m_dayRuns || m_turning; }

    void pass(Document& document, double seconds);
    void forget() { *this = {}; } // with the document that it was of

    void goOnFrom(const io::Environment& now); // the day, from the hour that the scene was given

    // In place of the scene's; none while nothing moves.
    std::optional<io::Environment> shown(const io::Environment& own) const;

private:
    struct Turning {
        io::Environment from, look; // another hand on the scene ends it
        double seconds = 0, passed = 0;
        std::string undoName;
    };
    io::Environment turned(const io::Environment& own) const;
    io::Environment withHours(io::Environment environment) const;

    bool m_dayRuns = false;
    double m_hours = 0;        // that the day has run on
    float m_since = 0;         // the scene's hour when it began: another one begins anew
    std::optional<Turning> m_turning;
};

} // namespace editor
