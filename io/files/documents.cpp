#include "io/files/documents.h"

#include "io/files/headed_file.h"
#include "io/scene/field_order.h"
#include "io/scene/shadow_ends.h"

#include <algorithm>

namespace io {
namespace {

// The line of a key of a section; of the section where the key is not written, and is a default.
std::string whereIs(const std::string& name, std::string_view text, std::string_view section, std::string_view key)
{
    const auto quoted = [](std::string_view word) { return '"' + std::string{word} + '"'; };
    const std::size_t start = text.find(quoted(section));
    if (start == text.npos) return name;
    const std::size_t end = std::min(text.find('}', start), text.size());
    const std::size_t found = text.substr(0, end).find(quoted(key), start);
    const std::size_t at = found == text.npos ? start : found;
    return name + ":" + std::to_string(1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n'));
}

// Ends of cascades that do not rise, which no single field can tell.
void checkShadows(Shadows& shadows, const std::string& name, std::string_view text, Complaints& complaints)
{
    const std::optional<EndFault> fault = endFault(shadows);
    if (!fault) return;
    complaints.push_back({Severity::Error, whereIs(name, text, "shadows", fault->key), "shadows." + fault->key + ": " + fault->what});
    spreadEnds(shadows);
}

void checkOrder(Environment& environment, const std::string& name, std::string_view text, Complaints& complaints)
{
    for (const OrderFault& fault : orderFaults(environment)) {
        const std::size_t dot = fault.greater.find('.');
        complaints.push_back({Severity::Error, whereIs(name, text, fault.greater.substr(0, dot), fault.greater.substr(dot + 1)),
                              std::string{fault.greater} + ": " + fault.what});
        keepOrder(environment, fault.less);
    }
}

} // namespace

Result<ProjectBody> readProjectText(std::string text, const std::string& name, Complaints& complaints)
{
    return readHeadedText<ProjectBody>(std::move(text), name, "wold-project", complaints);
}
Result<Environment> readEnvironmentText(std::string text, const std::string& name, Complaints& complaints)
{
    const std::string kept = text;
    Result<Environment> environment = readHeadedText<Environment>(std::move(text), name, "wold-environment", complaints);
    if (!environment) return environment;
    checkShadows(environment->shadows, name, kept, complaints);
    checkOrder(*environment, name, kept, complaints);
    return environment;
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
