#include "io/files/documents.h"

#include "io/files/headed_file.h"

namespace io {

Result<ProjectBody> readProjectText(std::string text, const std::string& name, Complaints& complaints)
{
    return readHeadedText<ProjectBody>(std::move(text), name, "wold-project", complaints);
}
Result<Environment> readEnvironmentText(std::string text, const std::string& name, Complaints& complaints)
{
    return readHeadedText<Environment>(std::move(text), name, "wold-environment", complaints);
}
Result<Template> readTemplateText(std::string text, const std::string& name, Complaints& complaints)
{
    return readHeadedText<Template>(std::move(text), name, "wold-template", complaints);
}

std::string projectText(const ProjectBody& project)
{
    return headedText(project, "wold-project");
}
std::string environmentText(const Environment& environment)
{
    return headedText(environment, "wold-environment");
}
std::string templateText(const Template& value)
{
    return headedText(value, "wold-template");
}

} // namespace io
