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
    bool moves() const { return m_dayRuns || m_turning; }

    void pass(Document& document, double seconds);
    void forget() { *this = {}; } // with the document that it was of

    // The scene has become `now`, as it was shown and edited: the day goes on from there, and no look comes any more.
    void goOnFrom(const io::Environment& now);

    // In place of the scene's; none while nothing moves.
    std::optional<io::Environment> shown(const io::Environment& own) const;

private:
    struct Turning {
        io::Environment look;
        double seconds = 0, passed = 0;
        std::string undoName;
    };
    io::Environment withHours(io::Environment environment) const;

    bool m_dayRuns = false;
    double m_hours = 0;        // that the day has run on
    float m_since = 0;         // the scene's hour when it began: another one begins anew
    std::optional<Turning> m_turning;
};

} // namespace editor
