// Arguments of one script command. The first fault sticks; finish() tells it, and keys that nobody asked for.
#pragma once

#include "editor/script.h"
#include "io/base/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace editor {

class Arguments {
public:
    Arguments(Script& script, const io::Value& command) : m_script{script}, m_command{command} { used("do"); }

    bool has(std::string_view key) const { return m_command.find(key) != nullptr; }
    const io::Value* value(std::string_view key); // marks it as used

    std::string text(std::string_view key); // must be there
    std::string text(std::string_view key, std::string_view fallback);
    double number(std::string_view key, double fallback, double min, double max);
    bool flag(std::string_view key, bool fallback);
    std::optional<glm::dvec2> pair(std::string_view key); // nothing when absent
    std::optional<glm::dvec3> triple(std::string_view key);
    std::optional<glm::dvec2> ground(std::string_view key);  // [x, z], or the x and z of [x, y, z]
    std::optional<glm::dvec3> factors(std::string_view key); // one number serves all three
    io::ObjectId object(std::string_view key);               // one that is in the scene
    std::vector<io::ObjectId> ids();                         // "ids", or the selection; never empty
    std::vector<io::ObjectId> instances();                   // likewise, of scatter layers
    io::TemplateId templateNamed(std::string_view key);

    void fail(std::string why)
    {
        if (!m_fault) m_fault = std::move(why);
    }
    // Call when everything was asked for and before anything is done.
    std::optional<io::Error> finish();

private:
    void used(std::string_view key) { m_used.push_back(key); }
    std::optional<std::vector<double>> numbers(std::string_view key, std::size_t count);
    io::TemplateId templateOf(const io::Value& name);
    io::ObjectId objectOf(const io::Value& id);
    friend std::vector<io::TemplateId> templatesOf(Arguments& arguments);

    Script& m_script;
    const io::Value& m_command;
    std::vector<std::string_view> m_used;
    std::optional<std::string> m_fault;
};

std::vector<io::TemplateId> templatesOf(Arguments& arguments); // "templates": names

io::Value toValue(const glm::dvec3& v);
io::Value toValue(std::span<const io::ObjectId> ids);

} // namespace editor
