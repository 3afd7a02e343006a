// Scalars: the values of a fields() list one after the other, component by component, so that many objects can be
// compared and edited without knowing what they are made of.
#pragma once

#include "io/scene/fields.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace editor {

using Scalar = std::variant<bool, double, std::string>; // an enum is the number of its name

template <class T, class Visitor>
concept HasFields = requires(Visitor& v, T& t)
{
    fields(v, t);
};
template <class T>
concept NamedEnum = std::is_enum_v<T> && requires(T t)
{
    enumNames(t);
};
template <class T>
concept Vector = requires(T t)
{
    typename T::value_type;
    {T::length()};
    t[0];
};

// Calls `f` with each scalar as a reference-like get and set. Lists of sections (layers, keys) and ids are left out.
class ScalarVisitor {
public:
    using Visit =
        std::function<void(const Scalar& value, const io::Hint& hint, const std::function<void(const Scalar&)>& set)>;
    explicit ScalarVisitor(Visit visit) : m_visit{std::move(visit)} {}

    template <class T> void operator()(const char*, T& value, const io::Hint& hint)
    {
        using Plain = std::remove_const_t<T>;
        if constexpr (HasFields<T, ScalarVisitor>) {
            fields(*this, value);
        } else if constexpr (std::is_same_v<Plain, bool> || std::is_same_v<Plain, std::string>) {
            m_visit(Scalar{value}, hint, [&](const Scalar& s) { assign(value, std::get<Plain>(s)); });
        } else if constexpr (std::is_arithmetic_v<Plain> || NamedEnum<Plain>) {
            number(value, hint);
        } else if constexpr (Vector<Plain>) {
            for (int i = 0; i < Plain::length(); ++i)
                number(value[i], hint);
        }
    }

private:
    template <class T> void number(T& value, const io::Hint& hint)
    {
        m_visit(Scalar{double(value)}, hint, [&](const Scalar& s) {
            assign(value, static_cast<std::remove_const_t<T>>(std::clamp(std::get<double>(s), hint.min, hint.max)));
        });
    }
    template <class T, class V> static void assign(T& to, V&& value)
    {
        if constexpr (!std::is_const_v<T>) to = std::forward<V>(value);
    }
    Visit m_visit;
};

template <class T> std::vector<Scalar> scalarsOf(const T& thing)
{
    std::vector<Scalar> result;
    ScalarVisitor visitor{[&](const Scalar& value, const io::Hint&, const auto&) { result.push_back(value); }};
    fields(visitor, thing);
    return result;
}

// What a person did to one scalar of the thing that is shown.
struct ScalarChange {
    std::size_t place = 0; // in the order of scalarsOf()
    Scalar value;
    bool relative = false; // the others become theirs * factor + delta instead of taking `value`
    double delta = 0;
    double factor = 1;
};

template <class T> void applyChanges(T& thing, const std::vector<ScalarChange>& changes)
{
    std::size_t place = 0;
    ScalarVisitor visitor{[&](const Scalar& value, const io::Hint&, const std::function<void(const Scalar&)>& set) {
        for (const ScalarChange& change : changes) {
            if (change.place != place) continue;
            const double* number = std::get_if<double>(&value);
            set(change.relative && number ? Scalar{*number * change.factor + change.delta} : change.value);
        }
        ++place;
    }};
    fields(visitor, thing);
}

} // namespace editor
