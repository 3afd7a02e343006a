#include "editor/live_environment.h"

#include "editor/commands.h"
#include "editor/text.h"
#include "io/scene/environment_mix.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace editor {
namespace {

constexpr double kSecondsAnHour = 3600;

// Where sun and moon stand, whoever says so: between an hour and a place by hand there is no other way.
io::Environment placedByHand(io::Environment environment)
{
    const glm::dvec3 sun = io::towardSun(environment);
    environment.sun.mode = io::SunMode::Manual;
    environment.sun.elevation = float(glm::degrees(std::asin(glm::clamp(sun.y, -1.0, 1.0))));
    environment.sun.azimuth = float(glm::degrees(std::atan2(sun.x, -sun.z)));
    return environment;
}

} // namespace

void LiveEnvironment::runDay(Document& document, bool on)
{
    if (on == m_dayRuns) return;
    const io::Environment own = document.scene().environment();
    if (!on && m_hours > 0) setEnvironment(document, tr("undo.day"), withHours(own));
    if (m_turning) m_turning->from = document.scene().environment();
    m_dayRuns = on;
    m_hours = 0;
    m_since = own.time;
}

void LiveEnvironment::turnInto(Document& document, io::Environment look, double seconds, std::string undoName)
{
    settle(document);
    if (seconds <= 0) return setEnvironment(document, std::move(undoName), std::move(look));
    m_turning = Turning{.from = document.scene().environment(), .look = std::move(look), .seconds = seconds, .undoName = std::move(undoName)};
}

void LiveEnvironment::settle(Document& document)
{
    if (!m_turning) return;
    io::Environment now = turned(document.scene().environment());
    setEnvironment(document, std::exchange(m_turning, std::nullopt)->undoName, std::move(now));
}

void LiveEnvironment::finish(Document& document)
{
    if (!m_turning) return;
    Turning done = *std::exchange(m_turning, std::nullopt);
    setEnvironment(document, std::move(done.undoName), std::move(done.look));
}

void LiveEnvironment::pass(Document& document, double seconds)
{
    const io::Environment& own = document.scene().environment();
    if (m_dayRuns) {
        if (own.time != m_since) m_hours = 0;
        m_since = own.time;
        m_hours += seconds * double(own.daySpeed) / kSecondsAnHour;
    }
    if (!m_turning) return;
    if (!(m_turning->from == own)) return stopTurning();
    m_turning->passed += seconds;
    if (m_turning->passed >= m_turning->seconds) finish(document);
}

void LiveEnvironment::goOnFrom(const io::Environment& now)
{
    m_hours = 0;
    m_since = now.time;
}

std::optional<io::Environment> LiveEnvironment::shown(const io::Environment& own) const
{
    if (!moves()) return std::nullopt;
    io::Environment now = turned(own);
    return m_dayRuns ? withHours(std::move(now)) : now;
}

io::Environment LiveEnvironment::turned(const io::Environment& own) const
{
    if (!m_turning) return own;
    const double share = std::min(m_turning->passed / m_turning->seconds, 1.0);
    const bool alike = own.sun.mode == m_turning->look.sun.mode;
    return alike ? io::mixed(own, m_turning->look, share) : io::mixed(placedByHand(own), placedByHand(m_turning->look), share);
}

io::Environment LiveEnvironment::withHours(io::Environment environment) const
{
    return io::hoursLater(std::move(environment), m_hours);
}

} // namespace editor
