#include "editor/numbers_text.h"

#include "editor/text.h"

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

} // namespace editor
