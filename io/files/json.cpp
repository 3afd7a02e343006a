#include "io/files/json.h"

#include "io/files/text.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <set>

namespace io {
namespace {

constexpr std::size_t kDeepest = 64;

// Reads the text byte by byte and counts the lines, because the parser's events do not say where they are.
class CountingIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* at, int* line) : m_at{at}, m_line{line} {}
    reference operator*() const { return *m_at; }
    CountingIterator& operator++()
    {
        if (*m_at == '\n') ++*m_line;
        ++m_at;
        return *this;
    }
    CountingIterator operator++(int)
    {
        CountingIterator before = *this;
        ++*this;
        return before;
    }
    bool operator==(const CountingIterator& other) const { return m_at == other.m_at; }
    bool operator!=(const CountingIterator& other) const { return m_at != other.m_at; }

private:
    const char* m_at;
    int* m_line;
};

// "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error …" -> the part worth reading.
std::string plainWords(std::string message)
{
    if (const auto bracket = message.find("] "); bracket != std::string::npos) message.erase(0, bracket + 2);
    if (const auto colon = message.find(": "); message.starts_with("parse error at") && colon != std::string::npos)
        message.erase(0, colon + 2);
    return repairedUtf8(message);
}

// Builds a Value from the parser's events, without recursion.
class Builder {
public:
    Builder(const int& line, Duplicates duplicates) : m_line{line}, m_duplicates{duplicates} {}

    bool null() { return put(Value{}); }
    bool boolean(bool b) { return put(b); }
    bool number_integer(std::int64_t i) { return put(i); }
    bool number_unsigned(std::uint64_t i) { return put(i); }
    bool number_float(double d, const std::string& text)
    {
        return std::isfinite(d) ? put(d) : fail(text + " is too large for a number");
    }
    bool string(std::string& s) { return put(std::move(s)); }
    bool binary(std::vector<std::uint8_t>&) { return fail("binary data"); }
    bool start_object(std::size_t) { return open(Value::Object{}); }
    bool start_array(std::size_t) { return open(Value::Array{}); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    bool key(std::string& name)
    {
        const bool fresh = m_open.back().keys.insert(name).second;
        if (!fresh && m_duplicates == Duplicates::Refuse) return fail(name + ": the key appears twice; remove one");
        m_open.back().key = std::move(name);
        return true;
    }
    template <class Exception> bool parse_error(std::size_t, const std::string&, const Exception& error)
    {
        return fail("not valid JSON: " + plainWords(error.what()));
    }

    Value result;
    std::optional<std::string> fault;
    int faultLine = 0;

private:
    struct Open {
        Value value;
        std::set<std::string> keys;
        std::string key; // of the member that is being read
    };

    bool fail(std::string what)
    {
        fault = std::move(what);
        faultLine = m_line;
        return false;
    }
    bool open(Value value)
    {
        if (m_open.size() == kDeepest) return fail("nested more than 64 deep; flatten it");
        m_open.push_back({std::move(value), {}, {}});
        return true;
    }
    bool close()
    {
        Value done = std::move(m_open.back().value);
        m_open.pop_back();
        return put(std::move(done));
    }
    bool put(Value value)
    {
        if (m_open.empty())
            result = std::move(value);
        else if (Value::Array* array = m_open.back().value.asArray())
            array->push_back(std::move(value));
        else
            putMember(*m_open.back().value.asObject(), std::move(m_open.back().key), std::move(value));
        return true;
    }
    void putMember(Value::Object& object, std::string key, Value value)
    {
        const bool again = m_open.back().keys.size() == object.size();
        if (!again) object.emplace_back(std::move(key), std::move(value));
    }

    const int& m_line;
    Duplicates m_duplicates;
    std::vector<Open> m_open;
};

bool holdsOnlyAtoms(const Value::Array& array)
{
    for (const Value& item : array)
        if (item.asArray() || item.asObject()) return false;
    return true;
}

class Writer {
public:
    explicit Writer(int indent) : m_indent{indent} {}
    std::string text;

    void write(const Value& value, int depth)
    {
        const double* number = value.asNumber();
        if (value.isNull() || (number && !std::isfinite(*number)))
            text += "null";
        else if (number)
            appendNumber(text, *number);
        else if (const bool* b = value.asBool())
            text += *b ? "true" : "false";
        else if (const std::string* s = value.asString())
            appendString(text, *s);
        else if (const Value::Array* array = value.asArray())
            writeArray(*array, depth);
        else
            writeObject(*value.asObject(), depth);
    }

private:
    void breakLine(int depth)
    {
        if (m_indent < 0) return;
        text += '\n';
        text.append(std::size_t(m_indent) * depth, ' ');
    }
    void writeArray(const Value::Array& array, int depth)
    {
        const bool oneLine = holdsOnlyAtoms(array);
        text += '[';
        for (std::size_t i = 0; i < array.size(); ++i) {
            if (i > 0) text += oneLine && m_indent >= 0 ? ", " : ",";
            if (!oneLine) breakLine(depth + 1);
            write(array[i], depth + 1);
        }
        if (!oneLine) breakLine(depth);
        text += ']';
    }
    void writeObject(const Value::Object& object, int depth)
    {
        text += '{';
        bool first = true;
        for (const auto& [key, value] : object) {
            if (!std::exchange(first, false)) text += ',';
            breakLine(depth + 1);
            appendString(text, key);
            text += m_indent < 0 ? ":" : ": ";
            write(value, depth + 1);
        }
        if (!object.empty()) breakLine(depth);
        text += '}';
    }

    int m_indent;
};

} // namespace

Result<Value> parseJson(std::string_view text, const std::string& where, Duplicates duplicates)
{
    int line = 1;
    Builder builder{line, duplicates};
    const CountingIterator first{text.data(), &line};
    const CountingIterator last{text.data() + text.size(), &line};
    try {
        if (nlohmann::json::sax_parse(first, last, &builder)) return std::move(builder.result);
    } catch (const std::exception& error) {
        builder.fault = plainWords(error.what());
        builder.faultLine = line;
    }
    return Error{where + ":" + std::to_string(builder.faultLine), builder.fault.value_or("not valid JSON")};
}

std::string writeJson(const Value& value, int indent)
{
    Writer writer{indent};
    writer.write(value, 0);
    return std::move(writer.text);
}

} // namespace io
