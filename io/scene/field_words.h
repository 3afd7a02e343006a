// The words of a field's faults, and the loose spellings that people type for values. Behind field_value.h.
#pragma once

#include "io/base/value.h"
#include "io/scene/fields.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace io {

using FieldFault = std::optional<std::string>; // what is wrong with a value; empty when it is right

std::string numberText(double number); // shortest
double decimal(float value);           // the double with the fewest digits that reads back to this float

// Empty when the value is none. `typed` also takes on, off, yes, no, true, false and numbers in quotes.
std::optional<bool> readBool(const Value& value, bool typed);
std::optional<double> readNumber(const Value& value, bool typed);
Value::Array readParts(const Value& value, bool typed);                       // [1,2,3], or "1,2,3"
int indexOfName(const Value& value, std::span<const std::string_view> names); // -1: none of them
std::optional<std::size_t> indexOfText(std::string_view text);
int axisOfName(char name); // x y z w, r g b a; -1

FieldFault checkNumber(double number, const Hint& hint, bool whole);
Value clamped(const Value& value, const Hint& hint); // numbers, also inside an array

std::string expected(std::string_view what, const Value& got);
std::string expectedOneOf(std::span<const std::string_view> names, const Value& got);
std::string unknownKey(std::string_view key, const std::vector<std::string>& known); // with those that are near

template <class Number> bool fits(double value)
{
    if constexpr (std::is_integral_v<Number>)
        return value >= double(std::numeric_limits<Number>::min()) &&
               value <= double(std::numeric_limits<Number>::max());
    return std::abs(value) <= double(std::numeric_limits<Number>::max());
}

} // namespace io
