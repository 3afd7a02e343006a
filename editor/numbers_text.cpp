#include "editor/numbers_text.h"

#include "editor/text.h"

#include <cmath>

namespace editor {

std::string grouped(std::uint64_t number)
{
    std::string digits = std::to_string(number);
    for (std::size_t at = digits.size(); at > 3;)
        digits.insert(at -= 3, tr("unit.thousands"));
    return digits;
}

std::string byteText(std::uint64_t bytes)
{
    constexpr const char* kUnits[] = {"unit.bytes", "unit.kilobytes", "unit.megabytes", "unit.gigabytes"};
    auto amount = double(bytes);
    std::size_t unit = 0;
    while (amount >= 1000 && unit + 1 < std::size(kUnits))
        amount /= 1000, ++unit;
    return fmt::format("{:.{}f} {}", amount, unit > 0 && amount < 100 ? 1 : 0, tr(kUnits[unit]));
}

std::string numberShown(double number, int decimals, bool bare)
{
    constexpr int kMost = 8;
    constexpr double kExact = 0.0005; // of the number
    if (bare) decimals = 0;
    const auto off = [&] { return std::abs(number - std::round(number * std::pow(10, decimals)) / std::pow(10, decimals)); };
    while (decimals < kMost && off() > kExact * std::abs(number))
        ++decimals;
    return fmt::format("{:.{}f}", number, decimals);
}

std::string clockShown(double hours)
{
    const long minutes = std::lround(std::abs(hours) * 60);
    return fmt::format("{}{}:{:02}", hours < 0 && minutes > 0 ? "-" : "", minutes / 60, minutes % 60);
}

} // namespace editor
