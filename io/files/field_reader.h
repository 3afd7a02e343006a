// Reads what fields() lists out of JSON text: unknown keys are kept and warned of, faults name FILE:LINE and the key.
#pragma once

#include "io/base/complaint.h"
#include "io/files/extra_path.h"
#include "io/scene/field_value.h"

#include <simdjson.h>

#include <array>
#include <functional>
#include <optional>
#include <span>

namespace io {

// Where in a document a reader is, as a chain on the stack: its words are made only when something is wrong.
struct Place {
    const Place* parent = nullptr;
    std::string_view key;
    int index = -1; // in a list, in place of a key

    std::string text() const
    {
        const std::string own = index >= 0 ? std::to_string(index) : std::string{key};
        const std::string before = parent ? parent->text() : std::string{};
        return before.empty() ? own : before + "." + own;
    }
};

// The text that is being read, and what there is to say about it.
class Source {
public:
    Source(std::string name, std::string_view text, Complaints& complaints)
        : m_name{std::move(name)}, m_text{text}, m_complaints{complaints}
    {
    }

    std::function<TemplateId(std::string_view name, const char* at)> templateNamed; // for files that hold objects

    const std::string& name() const { return m_name; }
    std::string_view text() const { return m_text; }
    std::string whereIs(const char* at) const;
    void complain(Severity severity, const char* at, std::string what);
    void complain(Severity severity, const char* at, const Place& place, const std::string& what)
    {
        complain(severity, at, place.text() + ": " + what);
    }
    void finish(); // says how many complaints were too many to list

private:
    std::string m_name;
    std::string_view m_text;
    Complaints& m_complaints;
    int m_count = 0;
};

using JsonValue = simdjson::ondemand::value;
using JsonObject = simdjson::ondemand::object;

// Parses `text` and gives the root object to `read`. Broken JSON is an error with its line.
Status readRoot(Source& source, const std::function<void(JsonObject)>& read);

bool isObject(JsonValue& value);
bool isArray(JsonValue& value);
const char* startOf(JsonValue& value);
std::string rawText(JsonValue value); // compact, checked to be JSON
Value atomOrList(JsonValue value);    // a list of atoms at most; anything deeper shows as null
std::optional<Value> readNumbers(JsonValue value, std::span<double> numbers); // what it is if no list of so many numbers

// ---- reading by type ------------------------------------------------------------------------------------------

// Whose Extra takes the unknown keys, and the path of the section from there.
struct Unknown {
    Extra* extra = nullptr;
    std::string prefix;
};

template <class T> Extra* extraOf(T& thing)
{
    if constexpr (requires { thing.extra; })
        return &thing.extra;
    else
        return nullptr;
}

template <class T>
void readValue(T& target, JsonValue value, const Hint& hint, const Place& place, const Unknown& unknown,
               Source& source);

// Visits the fields of a section and reads the one whose key is there.
struct KeyReader {
    std::string_view key;
    JsonValue& value;
    const Place& place;
    const Unknown& unknown;
    Source& source;
    int index = 0; // of the field among those of its section
    int found = -1;

    template <class T> void operator()(const char* name, T& target, const Hint& hint)
    {
        if (found < 0 && key == name) {
            found = index;
            readField(target, hint);
        }
        ++index;
    }

    std::uint64_t* seen = nullptr;

private:
    template <class T> void readField(T& target, const Hint& hint)
    {
        const std::uint64_t bit = std::uint64_t{1} << index;
        if (*seen & bit)
            return source.complain(Severity::Error, startOf(value), place, "the key appears twice; the first is used");
        *seen |= bit;
        Unknown inside{unknown.extra, {}};
        if constexpr (Section<T> || List<T>) inside.prefix = unknown.prefix + escapedKey(key) + ".";
        readValue(target, value, hint, place, inside, source);
    }
};

// Every member of `object` into `target`. `other(key, value, place)` may take keys that are no fields.
template <class T, class Other>
void readSection(T& target, JsonObject object, const Place* parent, const Unknown& unknown, Source& source, Other other)
{
    std::uint64_t seen = 0;
    for (auto member : object) {
        const std::string_view key = member.unescaped_key();
        JsonValue value = member.value();
        const Place place{parent, key};
        KeyReader reader{key, value, place, unknown, source};
        reader.seen = &seen;
        fields(reader, target);
        if (reader.found >= 0 || other(key, value, place)) continue;
        const char* at = startOf(value);
        source.complain(Severity::Warning, at, place, "unknown key; kept as it is");
        if (unknown.extra) unknown.extra->add(unknown.prefix + escapedKey(key), rawText(value));
    }
}

template <class T>
void readThing(T& target, JsonValue value, const Place& place, const Unknown& unknown, Source& source)
{
    if (!isObject(value))
        return source.complain(Severity::Error, startOf(value), place,
                               expected("an object in braces", atomOrList(value)));
    Extra* own = extraOf(target);
    const Unknown inside = own ? Unknown{own, {}} : unknown;
    readSection(target, value.get_object(), &place, inside, source, [](auto&&...) { return false; });
}

template <class T>
void readList(T& target, JsonValue value, const Hint& hint, const Place& place, const Unknown& unknown, Source& source)
{
    if (!isArray(value))
        return source.complain(Severity::Error, startOf(value), place,
                               expected("a list in brackets", atomOrList(value)));
    target.clear();
    for (auto item : value.get_array()) {
        const int index = int(target.size());
        const Unknown inside{unknown.extra, unknown.prefix + std::to_string(index) + "."};
        readValue(target.emplace_back(), item.value(), hint, Place{&place, {}, index}, inside, source);
    }
}

template <GlmVector T> bool setVector(T& target, std::span<const double> numbers, const Hint& hint)
{
    T read = target;
    for (int i = 0; i < VectorTraits<T>::kSize; ++i)
        if (fromValue(read[i], Value{numbers[std::size_t(i)]}, hint, Reading::File)) return false;
    target = read;
    return true;
}

template <class T> void readLeaf(T& target, JsonValue value, const Hint& hint, const Place& place, Source& source)
{
    const char* at = startOf(value);
    std::optional<Value> other;
    if constexpr (GlmVector<T>) { // most of a large scene: no Value is made of them unless something is wrong
        std::array<double, VectorTraits<T>::kSize> numbers{};
        other = readNumbers(value, numbers);
        if (!other && setVector(target, numbers, hint)) return;
        if (!other) other = Value::Array(numbers.begin(), numbers.end());
    }
    const Value read = other ? *std::move(other) : atomOrList(value);
    if (const FieldFault fault = fromValue(target, read, hint, Reading::File)) {
        source.complain(Severity::Error, at, place, *fault);
        clampToHint(target, read, hint);
    }
}

template <class T>
void readValue(T& target, JsonValue value, const Hint& hint, const Place& place, const Unknown& unknown, Source& source)
{
    if constexpr (std::is_same_v<T, TemplateId>) {
        std::string name;
        const char* at = startOf(value);
        if (const FieldFault fault = fromValue(name, atomOrList(value), hint, Reading::File))
            source.complain(Severity::Error, at, place, *fault);
        else
            target = source.templateNamed(name, at);
    } else if constexpr (Section<T>) {
        readThing(target, value, place, unknown, source);
    } else if constexpr (List<T>) {
        readList(target, value, hint, place, unknown, source);
    } else {
        readLeaf(target, value, hint, place, source);
    }
}

} // namespace io
