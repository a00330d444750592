#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/finding.h"
#include "io/site/clouds/cloud_file.h"

namespace rubble::io {

/// The lines of a cloud that is text, a window of it in memory.
class CloudLines {
public:
    /// @param start  of the first line in the file
    CloudLines(std::shared_ptr<const CloudFile> file, std::uint64_t start) : m_file(std::move(file)), m_next(start) {}

    /// The next line without its end and the blanks around it, valid until the next call. @return false at the end of the file
    /// Throws ParseError for a line that is longer than any of a cloud.
    bool next(std::string_view& line);
    /// Of the line behind that which was last given, in the file.
    std::uint64_t position() const { return m_next - (m_window.size() - m_at); }

private:
    bool load();

    std::shared_ptr<const CloudFile> m_file;
    std::uint64_t m_next;
    std::vector<char> m_window;
    std::size_t m_at = 0;
};

/// Number of a line in a file, from 1. @param end  behind its last byte, as CloudLines::position() has it
std::int64_t lineNumber(const CloudFile& file, std::uint64_t end);

/// Lines that could not be taken as points.
class UnreadLines {
public:
    /// @param end  of the line in the file
    void add(std::uint64_t end) { m_end = m_count++ == 0 ? end : m_end; }
    /// Counts them in a finding, with the first of them.
    void tell(const CloudFile& file, Findings& findings) const;

private:
    std::int64_t m_count = 0;
    std::uint64_t m_end = 0;  ///< of the first
};

/// How numbers of a line are parted.
struct LineForm {
    char separator = ' ';  ///< blank: any number of blanks
    bool decimalComma = false;
};

/// The fields of a line, at most so many. @return how many there are, none left out
std::size_t fieldsIn(std::string_view line, const LineForm& form, std::vector<std::string_view>& fields, std::size_t most);

/// The number of a field, which may be written as not a number; nothing where it is no number.
std::optional<double> fieldNumberIn(std::string_view field, const LineForm& form);
/// The same; not a number where it is none.
double fieldNumber(std::string_view field, const LineForm& form);

}  // namespace rubble::io
