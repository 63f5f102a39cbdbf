// Result<T>: what an expected failure of the outside world (file, command line, full disk) returns.
// The error says what happened, where, and what to do about it; a message, not a text. Values, any thread.
#pragma once
#include "runtime/base/message.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace plc {

struct Error {
    Message message;
    std::string place; // "file:line" or a path; empty when the message says it all
    [[nodiscard]] std::string english() const {
        return place.empty() ? message.english() : place + ": " + message.english();
    }
};

template <class T> class [[nodiscard]] Result {
public:
    Result(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : m_state(std::in_place_index<1>, std::move(error)) {}
    explicit operator bool() const { return m_state.index() == 0; }
    T& value() { return std::get<0>(m_state); }
    const T& value() const { return std::get<0>(m_state); }
    T& operator*() { return value(); }
    const T& operator*() const { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }
    const Error& error() const { return std::get<1>(m_state); }

private:
    std::variant<T, Error> m_state;
};

template <> class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : m_error(std::move(error)) {}
    explicit operator bool() const { return !m_error; }
    const Error& error() const { return *m_error; }

private:
    std::optional<Error> m_error;
};

} // namespace plc
