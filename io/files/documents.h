// The small files of a project as text: project.json, environments, templates.
#pragma once

#include "io/base/complaint.h"
#include "io/files/file_formats.h"

namespace io {

// `name` stands for the file in errors and complaints.
Result<ProjectBody> readProjectText(std::string text, const std::string& name, Complaints& complaints);
Result<Environment> readEnvironmentText(std::string text, const std::string& name, Complaints& complaints);
Result<Template> readTemplateText(std::string text, const std::string& name, Complaints& complaints);

std::string projectText(const ProjectBody& project);
std::string environmentText(const Environment& environment);
std::string templateText(const Template& value);

} // namespace io
