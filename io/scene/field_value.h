// The fields of a thing as Values: read and set by dotted path, with the ranges and names that fields() gives.
// Serves --set, the scripts' get and set, settings files and every reader of a project's files.
#pragma once

#include "io/base/result.h"
#include "io/base/value.h"
#include "io/scene/field_words.h"
#include "io/scene/fields.h"

#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace io {

struct AnyVisitor {
    void operator()(const char*, auto&, const Hint&) {}
};

template <class T>
concept Section = requires(AnyVisitor v, T& t)
{
    fields(v, t);
};

template <class T>
concept NamedEnum = std::is_enum_v<T> && requires(T t)
{
    enumNames(t);
};

template <class T> struct ListTraits : std::false_type {
};
template <class T> struct ListTraits<std::vector<T>> : std::true_type {
    using Item = T;
};
template <class T>
concept List = ListTraits<T>::value;

template <class T> struct VectorTraits : std::false_type {
};
template <int N, class T, glm::qualifier Q> struct VectorTraits<glm::vec<N, T, Q>> : std::true_type {
    static constexpr int kSize = N;
    using Component = T;
};
template <class T>
concept GlmVector = VectorTraits<T>::value;

// How strictly a Value must have a field's own type. People type words: "on", "1.5", "1,0.9,0.8".
enum class Reading { File, Typed };

// ---- to a Value -----------------------------------------------------------------------------------------------

template <class T> Value toValue(const T& value);

struct SectionToValue {
    Value::Object members;
    void operator()(const char* key, const auto& value, const Hint&) { members.emplace_back(key, toValue(value)); }
};

template <class T> Value toValue(const T& value)
{
    if constexpr (std::is_same_v<T, float>)
        return decimal(value);
    else if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, std::string> || std::is_arithmetic_v<T>)
        return value;
    else if constexpr (NamedEnum<T>)
        return enumNames(value)[std::size_t(value)];
    else if constexpr (std::is_enum_v<T>)
        return std::uint32_t(value); // an id
    else if constexpr (GlmVector<T>) {
        Value::Array components;
        for (int i = 0; i < VectorTraits<T>::kSize; ++i)
            components.push_back(toValue(value[i]));
        return components;
    } else if constexpr (List<T>) {
        Value::Array items;
        for (const auto& item : value)
            items.push_back(toValue(item));
        return items;
    } else {
        SectionToValue section;
        fields(section, value);
        return std::move(section.members);
    }
}

// ---- from a Value ---------------------------------------------------------------------------------------------

// Sets `target` from `value`, or leaves it alone and says what was expected. Sections and lists are read elsewhere:
// a file's by io/files, one field's by setField().
template <class T> FieldFault fromValue(T& target, const Value& value, const Hint& hint, Reading reading)
{
    if constexpr (std::is_same_v<T, bool>) {
        const std::optional<bool> b = readBool(value, reading == Reading::Typed);
        if (!b) return expected("true or false", value);
        target = *b;
    } else if constexpr (std::is_same_v<T, std::string>) {
        if (!value.asString()) return expected("a text in quotes", value);
        target = *value.asString();
    } else if constexpr (NamedEnum<T>) {
        const auto names = enumNames(target);
        const int index = indexOfName(value, names);
        if (index < 0) return expectedOneOf(names, value);
        target = T(index);
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
        using Number =
            typename std::conditional_t<std::is_enum_v<T>, std::underlying_type<T>, std::type_identity<T>>::type;
        const std::optional<double> n = readNumber(value, reading == Reading::Typed);
        if (!n) return expected("a number", value);
        if (FieldFault fault = checkNumber(*n, hint, std::is_integral_v<Number>)) return fault;
        if (!fits<Number>(*n)) return FieldFault{numberText(*n) + " is too large"};
        target = T(Number(*n));
    } else if constexpr (GlmVector<T>) {
        return vectorFromValue(target, value, hint, reading);
    } else {
        static_assert(Section<T> || List<T>);
        return FieldFault{"is a group of keys; name one of them"};
    }
    return {};
}

template <class T> FieldFault vectorFromValue(T& target, const Value& value, const Hint& hint, Reading reading)
{
    constexpr int kSize = VectorTraits<T>::kSize;
    const Value::Array parts = readParts(value, reading == Reading::Typed);
    if (int(parts.size()) != kSize) return expected(std::to_string(kSize) + " numbers in brackets", value);
    T read = target;
    for (int i = 0; i < kSize; ++i)
        if (FieldFault fault = fromValue(read[i], parts[std::size_t(i)], hint, reading)) return fault;
    target = read;
    return {};
}

// A value that is of the right type but outside its range, moved to the nearest end of it.
template <class T> void clampToHint(T& target, const Value& value, const Hint& hint)
{
    T nearest = target;
    Value moved = clamped(value, hint);
    if (!fromValue(nearest, moved, hint, Reading::File)) target = nearest;
}

// ---- by dotted path: "sun.azimuth", "layers.0.colour", "position.y" ---------------------------------------------

// Calls act(field, hint) on the field that `path` names.
template <class Act> class FieldSeeker {
public:
    FieldSeeker(std::string_view path, Act& act) : m_path{path}, m_act{act} {}
    bool found() const { return m_found; }

    template <class T> void operator()(std::string_view key, T& value, const Hint& hint)
    {
        if (m_found || !m_path.starts_with(key)) return;
        const std::string_view rest = m_path.substr(key.size());
        if (!rest.empty() && (rest.front() != '.' || rest.size() == 1)) return;
        m_found = seek(value, rest.empty() ? rest : rest.substr(1), hint);
    }

private:
    template <class T> bool seek(T& value, std::string_view rest, const Hint& hint)
    {
        using Plain = std::remove_const_t<T>;
        if (rest.empty()) {
            m_act(value, hint);
            return true;
        }
        if constexpr (List<Plain>)
            return seekItem(value, rest, hint);
        else if constexpr (GlmVector<Plain>) {
            const int axis = rest.size() == 1 ? axisOfName(rest[0]) : -1;
            return axis >= 0 && axis < VectorTraits<Plain>::kSize && seek(value[axis], {}, hint);
        } else if constexpr (Section<T>) {
            FieldSeeker inside{rest, m_act};
            fields(inside, value);
            return inside.found();
        }
        return false;
    }
    template <class T> bool seekItem(T& list, std::string_view rest, const Hint& hint)
    {
        const std::string_view first = rest.substr(0, rest.find('.'));
        const std::string_view after = first.size() == rest.size() ? std::string_view{} : rest.substr(first.size() + 1);
        const std::optional<std::size_t> index = indexOfText(first);
        return index && *index < list.size() && seek(list[*index], after, hint);
    }

    std::string_view m_path;
    Act& m_act;
    bool m_found = false;
};

class PathLister {
public:
    explicit PathLister(std::vector<std::string>& paths, std::string prefix = {})
        : m_paths{paths}, m_prefix{std::move(prefix)}
    {
    }
    template <class T> void operator()(const char* key, T& value, const Hint&) { list(value, m_prefix + key); }

private:
    template <class T> void list(T& value, const std::string& path)
    {
        if constexpr (List<std::remove_const_t<T>>) {
            for (std::size_t i = 0; i < value.size(); ++i)
                list(value[i], path + '.' + std::to_string(i));
        } else if constexpr (Section<T>) {
            PathLister inside{m_paths, path + '.'};
            fields(inside, value);
        } else {
            m_paths.push_back(path);
        }
    }

    std::vector<std::string>& m_paths;
    std::string m_prefix;
};

// Every leaf of `thing`, as "sun.azimuth".
template <class T> std::vector<std::string> fieldPaths(const T& thing)
{
    std::vector<std::string> paths;
    PathLister lister{paths};
    fields(lister, thing);
    return paths;
}

template <class T> Result<Value> getField(const T& thing, std::string_view path)
{
    Value value;
    auto read = [&](const auto& field, const Hint&) { value = toValue(field); };
    FieldSeeker seeker{path, read};
    fields(seeker, thing);
    if (!seeker.found()) return Error{std::string{path}, unknownKey(path, fieldPaths(thing))};
    return value;
}

// Reads what a person or a script says: "on", "1.5" and "1,2,3" will do as well as true, 1.5 and [1,2,3].
template <class T> Status setField(T& thing, std::string_view path, const Value& value)
{
    FieldFault fault;
    auto write = [&](auto& field, const Hint& hint) { fault = fromValue(field, value, hint, Reading::Typed); };
    FieldSeeker seeker{path, write};
    fields(seeker, thing);
    if (!seeker.found()) return Error{std::string{path}, unknownKey(path, fieldPaths(thing))};
    if (fault) return Error{std::string{path}, *fault};
    return {};
}

} // namespace io
