// A complaint is a fault that does not stop the work: what `wold check` lists and the console shows.
#pragma once

#include <string>
#include <vector>

namespace io {

enum class Severity { Note, Warning, Error };

struct Complaint {
    Severity severity = Severity::Warning;
    std::string where; // FILE[:LINE]
    std::string what;
};

using Complaints = std::vector<Complaint>;

} // namespace io
