// Value: JSON's data model as a plain value. Carries commands, settings, language files and answers between
// floors; the parser and the writer live in io/files/json.h.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace io {

class Value {
public:
    using Array = std::vector<Value>;
    using Member = std::pair<std::string, Value>;
    using Object = std::vector<Member>; // in the order of the text; a key appears once

    Value() = default; // null
    Value(std::nullptr_t) {}
    Value(bool b) : m_data{b} {}
    Value(double d) : m_data{d} {}
    Value(float f) : m_data{double(f)} {}
    Value(int i) : m_data{double(i)} {}
    Value(std::int64_t i) : m_data{double(i)} {}
    Value(std::uint64_t i) : m_data{double(i)} {} // exact up to 2^53
    Value(std::uint32_t i) : m_data{double(i)} {}
    Value(std::string s) : m_data{std::move(s)} {}
    Value(std::string_view s) : m_data{std::string{s}} {}
    Value(const char* s) : m_data{std::string{s}} {}
    Value(Array a) : m_data{std::move(a)} {}
    Value(Object o) : m_data{std::move(o)} {}

    bool isNull() const { return std::holds_alternative<std::monostate>(m_data); }
    const bool* asBool() const { return std::get_if<bool>(&m_data); }
    const double* asNumber() const { return std::get_if<double>(&m_data); }
    const std::string* asString() const { return std::get_if<std::string>(&m_data); }
    const Array* asArray() const { return std::get_if<Array>(&m_data); }
    const Object* asObject() const { return std::get_if<Object>(&m_data); }
    Array* asArray() { return std::get_if<Array>(&m_data); }
    Object* asObject() { return std::get_if<Object>(&m_data); }

    const Value* find(std::string_view key) const; // of an object; null when it is none or has no such key
    Value& operator[](std::string_view key);       // of an object (null becomes one); the key is made when missing

    bool operator==(const Value&) const = default;

private:
    std::variant<std::monostate, bool, double, std::string, Array, Object> m_data;
};

} // namespace io
