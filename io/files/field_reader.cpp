#include "io/files/field_reader.h"

#include "io/files/json.h"

#include <algorithm>
#include <charconv>

namespace io {
namespace {

using simdjson::ondemand::json_type;

constexpr int kMostComplaints = 50; // of one file

std::string_view token(JsonValue& value)
{
    std::string_view text = value.raw_json_token();
    while (!text.empty() && std::string_view{" \t\r\n"}.find(text.back()) != std::string_view::npos)
        text.remove_suffix(1);
    return text;
}

// A number too large for a double is a fault of one value; anything else that is no number breaks the document.
double number(JsonValue& value)
{
    double result = 0;
    const simdjson::error_code error = value.get_double().get(result);
    if (error == simdjson::SUCCESS) return result;
    const std::string_view text = token(value);
    if (std::from_chars(text.data(), text.data() + text.size(), result).ec == std::errc::result_out_of_range)
        return std::numeric_limits<double>::infinity();
    throw simdjson::simdjson_error{error};
}

Value atom(JsonValue value)
{
    switch (value.type()) {
    case json_type::number:
        return number(value);
    case json_type::string:
        return std::string_view{value.get_string()};
    case json_type::boolean:
        return bool{value.get_bool()};
    case json_type::null:
        if (!bool(value.is_null())) throw simdjson::simdjson_error{simdjson::N_ATOM_ERROR};
        return {};
    default:
        return {};
    }
}

// simdjson does not say where a document breaks: the slow parser does.
Error syntaxError(const Source& source, const char* reason)
{
    const Result<Value> slow = parseJson(source.text(), source.name());
    return slow ? Error{source.name(), std::string{"not valid JSON: "} + reason} : slow.error();
}

} // namespace

std::string Source::whereIs(const char* at) const
{
    const auto line = 1 + std::count(m_text.data(), std::min(at, m_text.data() + m_text.size()), '\n');
    return m_name + ":" + std::to_string(line);
}

void Source::complain(Severity severity, const char* at, std::string what)
{
    if (++m_count <= kMostComplaints) m_complaints.push_back({severity, whereIs(at), std::move(what)});
}

void Source::finish()
{
    if (m_count > kMostComplaints)
        m_complaints.push_back(
            {Severity::Warning, m_name, std::to_string(m_count - kMostComplaints) + " more like these"});
}

bool isObject(JsonValue& value)
{
    return value.type() == json_type::object;
}
bool isArray(JsonValue& value)
{
    return value.type() == json_type::array;
}
const char* startOf(JsonValue& value)
{
    return value.raw_json_token().data();
}

std::string rawText(JsonValue value)
{
    const std::string_view raw = isObject(value)  ? std::string_view{value.get_object().value().raw_json()}
                                 : isArray(value) ? std::string_view{value.get_array().value().raw_json()}
                                                  : token(value);
    if (!parseJson(raw, "")) throw simdjson::simdjson_error{simdjson::TAPE_ERROR};
    std::string compact(raw.size(), '\0');
    std::size_t size = 0;
    if (simdjson::minify(raw.data(), raw.size(), compact.data(), size) != simdjson::SUCCESS) return std::string{raw};
    compact.resize(size);
    return compact;
}

Value atomOrList(JsonValue value)
{
    if (isArray(value)) {
        Value::Array items;
        for (auto item : value.get_array())
            items.push_back(atom(item.value()));
        return items;
    }
    return isObject(value) ? Value{Value::Object{}} : atom(value);
}

std::optional<Value> readNumbers(JsonValue value, std::span<double> numbers)
{
    if (!isArray(value)) return atomOrList(value);
    Value::Array items; // once there is something else
    std::size_t count = 0;
    bool plain = true;
    const auto giveUp = [&] {
        items.assign(numbers.begin(), numbers.begin() + std::ptrdiff_t(count));
        plain = false;
    };
    for (auto item : value.get_array()) {
        JsonValue one = item.value();
        if (plain && (count == numbers.size() || one.type() != json_type::number)) giveUp();
        if (plain)
            numbers[count++] = number(one);
        else
            items.push_back(atom(one));
    }
    if (plain && count == numbers.size()) return std::nullopt;
    if (plain) giveUp();
    return items;
}

Status readRoot(Source& source, const std::function<void(JsonObject)>& read)
{
    constexpr std::string_view kMark = "\xEF\xBB\xBF"; // byte order mark
    std::string_view text = source.text();
    if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
    try {
        simdjson::ondemand::parser parser;
        auto document = parser.iterate(text.data(), text.size(), text.size() + simdjson::SIMDJSON_PADDING).value();
        JsonObject root;
        if (document.get_object().get(root) != simdjson::SUCCESS)
            return syntaxError(source, "the file must hold one object in braces");
        read(root);
        const char* rest = nullptr;
        if (document.current_location().get(rest) == simdjson::SUCCESS)
            return syntaxError(source, "more text follows the end of the object");
    } catch (const simdjson::simdjson_error& error) {
        return syntaxError(source, error.what());
    }
    return {};
}

} // namespace io
