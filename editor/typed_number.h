// What a person types into a number: "2.5", "2,5", "10:30" (hours), or a change of the old value: "+=2", "*=0.5".
#pragma once

#include <optional>
#include <string_view>

namespace editor {

struct TypedNumber {
    bool relative = false; // old value * factor + delta
    double value = 0;      // when it is not
    double factor = 1, delta = 0;

    double of(double old) const { return relative ? old * factor + delta : value; }
};

std::optional<TypedNumber> typedNumber(std::string_view text); // nothing when it is no finite number

} // namespace editor
