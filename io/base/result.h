// Result<T>: a value, or the world's fault (a file, a shader, a person's data) in words that a person can act on.
#pragma once

#include "io/base/contract.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace io {

// `where` is FILE, FILE:LINE or FILE:LINE: KEY; `what` says what is wrong and what to do.
struct Error {
    std::string where;
    std::string what;

    std::string text() const { return where.empty() ? what : where + ": " + what; }
};

template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : m_state{std::in_place_index<0>, std::move(value)} {}
    Result(Error error) : m_state{std::in_place_index<1>, std::move(error)} {}

    explicit operator bool() const { return m_state.index() == 0; }
    T& value() &
    {
        EXPECTS(*this);
        return std::get<0>(m_state);
    }
    const T& value() const&
    {
        EXPECTS(*this);
        return std::get<0>(m_state);
    }
    T&& value() &&
    {
        EXPECTS(*this);
        return std::get<0>(std::move(m_state));
    }
    const Error& error() const
    {
        EXPECTS(!*this);
        return std::get<1>(m_state);
    }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

private:
    std::variant<T, Error> m_state;
};

template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : m_error{std::move(error)} {}

    explicit operator bool() const { return !m_error; }
    const Error& error() const
    {
        EXPECTS(m_error.has_value());
        return *m_error;
    }

private:
    std::optional<Error> m_error;
};

using Status = Result<void>;

} // namespace io
