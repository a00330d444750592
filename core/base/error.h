#pragma once

#include <exception>
#include <string>

#include "core/base/message.h"

namespace rubble {

/// Root of all errors that Rubble raises on purpose. Every one says what, where and what to do about it.
class Error : public std::exception {
public:
    /// @param what    what went wrong, with the file or the place named in it
    /// @param remedy  what the user can do
    Error(Message what, Message remedy);

    const char* what() const noexcept override { return m_text.c_str(); }
    const Message& message() const { return m_message; }
    const Message& remedy() const { return m_remedy; }

private:
    Message m_message;
    Message m_remedy;
    std::string m_text;
};

/// The world outside failed: a file that cannot be read, a full disk, a missing program.
class WorldError : public Error {
public:
    using Error::Error;
};

/// A file was read but its content is not what it should be. The message names file, place and what was found there.
class ParseError : public Error {
public:
    using Error::Error;
};

/// A request that cannot be met as put: an unknown parameter, a value out of range, an unknown export kind.
class UsageError : public Error {
public:
    using Error::Error;
};

/// The user cancelled. Nothing is wrong; partial results are kept.
class Cancelled : public std::exception {
public:
    const char* what() const noexcept override { return "cancelled"; }
};

}  // namespace rubble
