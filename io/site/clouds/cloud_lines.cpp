#include "io/site/clouds/cloud_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "io/base/file_words.h"
#include "io/base/trimmed.h"

namespace rubble::io {

namespace {

constexpr std::size_t windowOfLines = std::size_t{1} << 18;
constexpr std::size_t longestLine = std::size_t{1} << 16;

}  // namespace

bool CloudLines::load() {
    m_window.erase(m_window.begin(), m_window.begin() + static_cast<std::ptrdiff_t>(m_at));
    m_at = 0;
    const std::size_t kept = m_window.size();
    m_window.resize(kept + windowOfLines);
    const std::size_t got = m_file->readSome(m_next, reinterpret_cast<unsigned char*>(m_window.data()) + kept, windowOfLines);
    m_window.resize(kept + got);
    m_next += got;
    return got > 0;
}

bool CloudLines::next(std::string_view& line) {
    std::size_t seen = 0;
    for (;;) {
        const auto begin = m_window.begin() + static_cast<std::ptrdiff_t>(m_at);
        const auto end = std::find(begin + static_cast<std::ptrdiff_t>(seen), m_window.end(), '\n');
        const bool whole = end != m_window.end();
        const auto bytes = static_cast<std::size_t>(end - begin);
        if (bytes > longestLine) {
            refuseContent({"cloud.long_line", "{0}: a line is longer than any of a point cloud", {m_file->path()}},
                          "Check that the file is what its name says.");
        }
        if (whole || !load()) {
            line = trimmed({m_window.data() + m_at, bytes});
            m_at += bytes + (whole ? 1 : 0);
            return whole || bytes > 0;
        }
        seen = bytes;
    }
}

std::size_t fieldsIn(std::string_view line, const LineForm& form, std::vector<std::string_view>& fields, std::size_t most) {
    fields.clear();
    std::size_t count = 0;
    const bool blanks = form.separator == ' ';
    const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
    for (std::size_t at = 0; at < line.size();) {
        std::size_t end = at;
        while (end < line.size() && !(blanks ? isBlank(line[end]) : line[end] == form.separator)) {
            ++end;
        }
        if (end > at || !blanks) {
            if (fields.size() < most) {
                fields.push_back(trimmed(line.substr(at, end - at)));
            }
            ++count;
        }
        at = end + 1;
    }
    return count;
}

std::optional<double> fieldNumberIn(std::string_view field, const LineForm& form) {
    std::array<char, 64> own{};
    if (field.starts_with('+')) {
        field.remove_prefix(1);
    }
    if (form.decimalComma && field.size() < own.size()) {
        std::replace_copy(field.begin(), field.end(), own.begin(), ',', '.');
        field = {own.data(), field.size()};
    }
    double number = 0.0;
    const auto end = std::from_chars(field.data(), field.data() + field.size(), number);
    return end.ec == std::errc{} && end.ptr == field.data() + field.size() ? std::optional(number) : std::nullopt;
}

double fieldNumber(std::string_view field, const LineForm& form) {
    return fieldNumberIn(field, form).value_or(std::numeric_limits<double>::quiet_NaN());
}

std::int64_t lineNumber(const CloudFile& file, std::uint64_t end) {
    std::vector<unsigned char> window(windowOfLines);
    std::int64_t line = 1;
    // The last byte may be the end of the line itself.
    for (std::uint64_t at = 0; at + 1 < end;) {
        const std::size_t got = file.readSome(at, window.data(), std::min<std::uint64_t>(window.size(), end - 1 - at));
        if (got == 0) {
            break;
        }
        line += std::count(window.begin(), window.begin() + static_cast<std::ptrdiff_t>(got), '\n');
        at += got;
    }
    return line;
}

void UnreadLines::tell(const CloudFile& file, Findings& findings) const {
    if (m_count > 0) {
        addFinding(
            findings, file.path(),
            {"cloud.lines_unread",
             "lines that are no points were left out, the first of them line {0}: they have too few numbers, or words for them",
             {lineNumber(file, m_end)}},
            "look at the file in an editor; export it anew if these are points", m_count);
    }
}

}  // namespace rubble::io
