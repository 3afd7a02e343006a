// The player's actions, and what does them where a project does not say otherwise.
#pragma once

#include "io/files/project.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace io {

std::span<const std::string_view> playActions(); // "forward", "jump", ...: in the order in which they are listed

std::vector<std::string> usualControls(std::string_view action);
// Those of the project, or the usual ones. None at all where the project took them away, which an empty `by` says.
std::vector<std::string> controlsOf(std::span<const Control> controls, std::string_view action);
// The list with these as the action's controls: those that are usual are not written down.
std::vector<Control> withControls(std::span<const Control> controls, std::string_view action, const std::vector<std::string>& by);

} // namespace io
