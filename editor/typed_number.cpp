#include "editor/typed_number.h"

#include <charconv>
#include <cmath>
#include <string>

namespace editor {
namespace {

std::optional<double> plain(std::string_view text)
{
    std::string clean;
    for (const char c : text)
        if (c != ' ' && !(c == '+' && clean.empty())) clean += c == ',' ? '.' : c;
    double number = 0;
    const char* end = clean.data() + clean.size();
    const auto [stop, fault] = std::from_chars(clean.data(), end, number);
    if (clean.empty() || fault != std::errc{} || stop != end || !std::isfinite(number)) return {};
    return number;
}

std::optional<double> hoursAndMinutes(std::string_view text, std::size_t colon)
{
    const auto hours = plain(text.substr(0, colon)), minutes = plain(text.substr(colon + 1));
    if (!hours || !minutes || *minutes < 0 || *minutes >= 60) return {};
    return *hours + *minutes / 60;
}

std::optional<TypedNumber> relation(char op, double amount)
{
    switch (op) {
    case '+':
        return TypedNumber{.relative = true, .delta = amount};
    case '-':
        return TypedNumber{.relative = true, .delta = -amount};
    case '*':
        return TypedNumber{.relative = true, .factor = amount};
    case '/':
        if (amount == 0) return {};
        return TypedNumber{.relative = true, .factor = 1 / amount};
    default:
        return {};
    }
}

} // namespace

std::optional<TypedNumber> typedNumber(std::string_view text)
{
    while (!text.empty() && text.front() == ' ')
        text.remove_prefix(1);
    if (text.size() > 2 && text[1] == '=') {
        const auto amount = plain(text.substr(2));
        return amount ? relation(text[0], *amount) : std::nullopt;
    }
    const std::size_t colon = text.find(':');
    const auto number = colon == std::string_view::npos ? plain(text) : hoursAndMinutes(text, colon);
    if (!number) return {};
    return TypedNumber{.value = *number};
}

} // namespace editor
