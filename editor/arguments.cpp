#include "editor/arguments.h"

#include "editor/instance_edits.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace editor {
namespace {

constexpr double kFarthest = 1e7; // m; also fits every other number a command takes

std::string inQuotes(std::string_view key)
{
    return '"' + std::string{key} + '"';
}

} // namespace

const io::Value* Arguments::value(std::string_view key)
{
    used(key);
    return m_command.find(key);
}

std::string Arguments::text(std::string_view key)
{
    if (!has(key)) fail("needs " + inQuotes(key));
    return text(key, {});
}

std::string Arguments::text(std::string_view key, std::string_view fallback)
{
    const io::Value* found = value(key);
    if (!found) return std::string{fallback};
    if (!found->asString()) fail(inQuotes(key) + " must be a text");
    return found->asString() ? *found->asString() : std::string{};
}

double Arguments::number(std::string_view key, double fallback, double min, double max)
{
    const io::Value* found = value(key);
    if (!found) return fallback;
    const double* number = found->asNumber();
    if (!number || !(*number >= min && *number <= max))
        fail(fmt::format("{} must be a number from {} to {}", inQuotes(key), min, max));
    return number ? *number : fallback;
}

bool Arguments::flag(std::string_view key, bool fallback)
{
    const io::Value* found = value(key);
    if (!found) return fallback;
    if (!found->asBool()) fail(inQuotes(key) + " must be true or false");
    return found->asBool() ? *found->asBool() : fallback;
}

std::optional<std::vector<double>> Arguments::numbers(std::string_view key, std::size_t count)
{
    const io::Value* found = value(key);
    if (!found) return std::nullopt;
    std::vector<double> result;
    if (const io::Value::Array* items = found->asArray())
        for (const io::Value& item : *items)
            if (const double* number = item.asNumber(); number && std::abs(*number) <= kFarthest)
                result.push_back(*number);
    if (!found->asArray() || found->asArray()->size() != count || result.size() != count) {
        fail(
            fmt::format("{} must be {} numbers in brackets, each at most {} in size", inQuotes(key), count, kFarthest));
        result.assign(count, 0);
    }
    return result;
}

std::optional<glm::dvec2> Arguments::pair(std::string_view key)
{
    const auto n = numbers(key, 2);
    return n ? std::optional{glm::dvec2{(*n)[0], (*n)[1]}} : std::nullopt;
}

std::optional<glm::dvec3> Arguments::triple(std::string_view key)
{
    const auto n = numbers(key, 3);
    return n ? std::optional{glm::dvec3{(*n)[0], (*n)[1], (*n)[2]}} : std::nullopt;
}

std::optional<glm::dvec2> Arguments::ground(std::string_view key)
{
    const io::Value* found = m_command.find(key);
    if (!found || !found->asArray() || found->asArray()->size() != 3) return pair(key);
    const glm::dvec3 point = *triple(key);
    return glm::dvec2{point.x, point.z};
}

std::optional<glm::dvec3> Arguments::factors(std::string_view key)
{
    const io::Value* found = m_command.find(key);
    std::optional<glm::dvec3> result = found && found->asNumber() ? glm::dvec3{number(key, 1, -1e6, 1e6)} : triple(key);
    if (result)
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs((*result)[axis]) >= 1e-6 && std::abs((*result)[axis]) <= 1e6))
                fail(inQuotes(key) + " must be factors from 1e-6 to 1e6 in size");
    return result;
}

io::ObjectId Arguments::objectOf(const io::Value& id)
{
    const double* number = id.asNumber();
    const bool whole = number && *number >= 1 && *number <= 4294967295.0 && *number == std::floor(*number);
    const io::ObjectId found{whole ? std::uint32_t(*number) : 0};
    if (!whole)
        fail("an id is a whole number from 1 up");
    else if (!m_script.document().scene().find(found))
        fail(fmt::format("there is no object {}", io::number(found)));
    return found;
}

io::ObjectId Arguments::object(std::string_view key)
{
    const io::Value* found = value(key);
    if (!found) fail("needs " + inQuotes(key));
    return found ? objectOf(*found) : io::ObjectId::None;
}

std::vector<io::ObjectId> Arguments::ids()
{
    std::vector<io::ObjectId> result;
    if (const io::Value* found = value("ids")) {
        if (!found->asArray()) fail("\"ids\" must be numbers in brackets");
        if (const io::Value::Array* items = found->asArray())
            for (const io::Value& item : *items)
                result.push_back(objectOf(item));
    } else {
        result = withoutInstances(m_script.selection().ids());
    }
    if (result.empty()) fail("nothing is selected; select something or give \"ids\"");
    return result;
}

std::vector<io::ObjectId> Arguments::instances()
{
    const io::Scene& scene = m_script.document().scene();
    std::vector<io::ObjectId> result;
    if (const io::Value* found = value("ids")) {
        if (!found->asArray()) fail("\"ids\" must be numbers in brackets");
        if (const io::Value::Array* items = found->asArray())
            for (const io::Value& item : *items) {
                const double number = item.asNumber() ? *item.asNumber() : 0;
                const io::ObjectId id{number >= 1 && number <= io::kLastInstanceId && number == std::floor(number) ? std::uint32_t(number) : 0};
                if (!scene.findInstance(id)) fail("\"ids\" must be those of instances, as \"instances\" and \"pick\" answer them");
                result.push_back(id);
            }
    } else {
        result = instancesAmong(scene, m_script.selection().ids());
    }
    if (result.empty()) fail("no instance is selected; select some or give \"ids\"");
    return result;
}

io::TemplateId Arguments::templateOf(const io::Value& name)
{
    const io::Scene& scene = m_script.document().scene();
    const std::string* words = name.asString();
    const io::TemplateId id = words ? scene.findTemplate(*words) : io::TemplateId::None;
    if (!words)
        fail("a template is named by a text");
    else if (!scene.find(id))
        fail("there is no template " + inQuotes(*words));
    return id;
}

io::TemplateId Arguments::templateNamed(std::string_view key)
{
    const io::Value* found = value(key);
    if (!found) fail("needs " + inQuotes(key));
    return found ? templateOf(*found) : io::TemplateId::None;
}

std::vector<io::TemplateId> templatesOf(Arguments& arguments)
{
    std::vector<io::TemplateId> result;
    const io::Value* names = arguments.value("templates");
    if (names && names->asArray())
        for (const io::Value& name : *names->asArray())
            result.push_back(arguments.templateOf(name));
    else if (names)
        result.push_back(arguments.templateOf(*names));
    if (result.empty()) arguments.fail("needs \"templates\"");
    return result;
}

std::optional<io::Error> Arguments::finish()
{
    if (!m_fault)
        for (const io::Value::Member& member : *m_command.asObject())
            if (std::ranges::find(m_used, member.first) == m_used.end())
                fail("does not know " + inQuotes(member.first));
    if (!m_fault) return std::nullopt;
    return io::Error{{}, *m_fault};
}

io::Value toValue(const glm::dvec3& v)
{
    return io::Value::Array{v.x, v.y, v.z};
}

io::Value toValue(std::span<const io::ObjectId> ids)
{
    io::Value::Array numbers;
    numbers.reserve(ids.size());
    for (const io::ObjectId id : ids)
        numbers.emplace_back(io::number(id));
    return numbers;
}

} // namespace editor
