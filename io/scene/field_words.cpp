#include "io/scene/field_words.h"

#include <algorithm>
#include <charconv>

namespace io {
namespace {

std::optional<double> parsed(std::string_view text)
{
    while (!text.empty() && text.front() == ' ')
        text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ')
        text.remove_suffix(1);
    if (text.starts_with('+')) text.remove_prefix(1);
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

std::string shown(const Value& value)
{
    if (value.isNull()) return "null";
    if (const bool* b = value.asBool()) return *b ? "true" : "false";
    if (const double* n = value.asNumber()) return numberText(*n);
    if (const std::string* s = value.asString())
        return s->size() <= 40 ? '"' + *s + '"' : "a text of " + std::to_string(s->size()) + " bytes";
    if (const Value::Array* a = value.asArray()) return "a list of " + std::to_string(a->size());
    return "an object";
}

// Levenshtein's distance: letters to add, drop or change.
std::size_t distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, change});
        }
    }
    return row.back();
}

std::string_view leaf(std::string_view path)
{
    return path.substr(path.rfind('.') + 1);
}

std::vector<std::string_view> nearest(std::string_view key, const std::vector<std::string>& known)
{
    std::vector<std::pair<std::size_t, std::string_view>> near;
    for (const std::string& candidate : known) {
        const std::size_t d = std::min(distance(key, candidate), distance(leaf(key), leaf(candidate)) + 1);
        if (d <= std::max<std::size_t>(2, leaf(key).size() / 3)) near.emplace_back(d, candidate);
    }
    std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < std::min<std::size_t>(near.size(), 4); ++i)
        names.push_back(near[i].second);
    return names;
}

std::string listed(std::span<const std::string_view> names)
{
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
        text += names[i];
    }
    return text;
}

} // namespace

std::string numberText(double number)
{
    char digits[32];
    const bool whole = std::abs(number) < 1e15 && number == std::trunc(number);
    const auto end = whole ? std::to_chars(digits, digits + sizeof digits, static_cast<long long>(number))
                           : std::to_chars(digits, digits + sizeof digits, number);
    return {digits, end.ptr};
}

double decimal(float value)
{
    if (!std::isfinite(value)) return value;
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    double result = 0;
    std::from_chars(digits, end, result);
    return float(result) == value ? result : double(value);
}

std::optional<bool> readBool(const Value& value, bool typed)
{
    if (const bool* b = value.asBool()) return *b;
    const std::string* word = typed ? value.asString() : nullptr;
    if (!word) return std::nullopt;
    if (*word == "on" || *word == "true" || *word == "yes" || *word == "1") return true;
    if (*word == "off" || *word == "false" || *word == "no" || *word == "0") return false;
    return std::nullopt;
}

std::optional<double> readNumber(const Value& value, bool typed)
{
    if (const double* n = value.asNumber()) return *n;
    return typed && value.asString() ? parsed(*value.asString()) : std::nullopt;
}

Value::Array readParts(const Value& value, bool typed)
{
    if (const Value::Array* parts = value.asArray()) return *parts;
    Value::Array parts;
    if (!typed || !value.asString()) return parts;
    std::string_view text = *value.asString();
    if (text.starts_with('[') && text.ends_with(']')) text = text.substr(1, text.size() - 2);
    while (true) {
        const std::size_t comma = text.find(',');
        parts.emplace_back(text.substr(0, comma));
        if (comma == std::string_view::npos) return parts;
        text.remove_prefix(comma + 1);
    }
}

int indexOfName(const Value& value, std::span<const std::string_view> names)
{
    const std::string* name = value.asString();
    const auto found = name ? std::find(names.begin(), names.end(), *name) : names.end();
    return found == names.end() ? -1 : int(found - names.begin());
}

std::optional<std::size_t> indexOfText(std::string_view text)
{
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional{index} : std::nullopt;
}

int axisOfName(char name)
{
    const std::size_t at = std::string_view{"xyzwrgba"}.find(name);
    return at == std::string_view::npos ? -1 : int(at % 4);
}

FieldFault checkNumber(double number, const Hint& hint, bool whole)
{
    if (!std::isfinite(number)) return "must be a finite number";
    if (whole && number != std::floor(number)) return numberText(number) + " must be a whole number";
    if (number >= hint.min && number <= hint.max) return {};
    const std::string unit = *hint.unit ? std::string{" "} + hint.unit : std::string{};
    if (hint.max == std::numeric_limits<double>::max())
        return numberText(number) + " must be at least " + numberText(hint.min) + unit;
    return numberText(number) + " is outside " + numberText(hint.min) + " to " + numberText(hint.max) + unit;
}

Value clamped(const Value& value, const Hint& hint)
{
    if (const double* number = value.asNumber()) return std::clamp(*number, hint.min, hint.max);
    const Value::Array* parts = value.asArray();
    if (!parts) return value;
    Value::Array moved;
    for (const Value& part : *parts)
        moved.push_back(clamped(part, hint));
    return moved;
}

std::string expected(std::string_view what, const Value& got)
{
    return "expected " + std::string{what} + ", found " + shown(got);
}

std::string expectedOneOf(std::span<const std::string_view> names, const Value& got)
{
    return expected(listed(names), got);
}

std::string unknownKey(std::string_view key, const std::vector<std::string>& known)
{
    const std::vector<std::string_view> near = nearest(key, known);
    return "unknown key" + (near.empty() ? std::string{} : "; did you mean " + listed(near) + "?");
}

} // namespace io
