// Progress of a long piece of work, and the way to stop it.
#pragma once

#include <functional>
#include <string_view>

namespace io {

// Called with the fraction done (0..1) and the name of the step; answers false to cancel the work.
using Progress = std::function<bool(float fraction, std::string_view step)>;

inline bool report(const Progress& progress, float fraction, std::string_view step)
{
    return !progress || progress(fraction, step);
}

} // namespace io
