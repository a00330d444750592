#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/fe/vtk/stored_numbers.h"

namespace rubble::io {

/// A legacy VTK file in memory, read from front to end: words and lines of text, and lists of numbers that are text or big-endian
/// bytes. Counts are held against what is left of the file before anything is taken into memory.
class LegacyText {
public:
    /// Throws WorldError.
    explicit LegacyText(const std::string& path);
    LegacyText(const LegacyText&) = delete;
    LegacyText& operator=(const LegacyText&) = delete;

    const std::string& path() const { return m_path; }
    std::uint64_t place() const { return m_text.size() - m_left.size(); }
    /// Goes back to a place where it was before.
    void seek(std::uint64_t place) { m_left = std::string_view(m_text).substr(static_cast<std::size_t>(place)); }
    void setBinary(bool binary) { m_binary = binary; }
    bool atEnd() const { return m_left.empty(); }

    /// The next word; empty at the end.
    std::string word();
    /// The rest of the line.
    std::string line();
    /// A number of things, as headings have it. @param what  named in errors
    std::uint64_t count(const char* what);

    /// `count` numbers of a type that a heading names ("float", "vtktypeint64", ...).
    std::vector<double> reals(std::uint64_t count, const std::string& type, const std::string& what);
    std::vector<std::int64_t> integers(std::uint64_t count, const std::string& type, const std::string& what);
    void skip(std::uint64_t count, const std::string& type, const std::string& what);

    [[noreturn]] void fail(const std::string& why) const;
    [[noreturn]] void failCut(const std::string& what) const;

private:
    template <class T>
    std::vector<T> numbers(std::uint64_t count, const std::string& type, const std::string& what);
    std::vector<std::int64_t> bits(std::uint64_t count, const std::string& what);
    void skipTexts(std::uint64_t count, const std::string& what);
    NumberType typeOf(const std::string& type) const;
    std::string_view bytes(std::uint64_t count, std::size_t each, const std::string& what);

    std::string m_path;
    std::string m_text;
    std::string_view m_left;
    bool m_binary = false;
};

/// A name as it was before it was written: blanks and the like stand there as %20.
std::string legacyName(const std::string& written);

}  // namespace rubble::io
