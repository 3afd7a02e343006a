// Numbers from words, whatever the locale.
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

namespace app {

template <class T> std::optional<T> toNumber(std::string_view text)
{
    T value{};
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    if constexpr (std::is_floating_point_v<T>)
        if (!std::isfinite(value)) return std::nullopt;
    return value;
}

inline std::vector<std::string_view> split(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t at = text.find(separator);
        parts.push_back(text.substr(0, at));
        if (at == std::string_view::npos) return parts;
        text.remove_prefix(at + 1);
    }
}

// Empty when any of them is not a finite number.
inline std::vector<double> toNumbers(std::string_view text, char separator)
{
    std::vector<double> numbers;
    for (const std::string_view part : split(text, separator)) {
        const auto number = toNumber<double>(part);
        if (!number) return {};
        numbers.push_back(*number);
    }
    return numbers;
}

} // namespace app
