#include "io/fe/series/byte_window.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "io/base/files.h"

namespace rubble::io {

namespace {

constexpr std::size_t windowBytes = std::size_t{1} << 18;
constexpr std::size_t longestLine = 4096;

}  // namespace

ByteWindow::ByteWindow(const std::string& path) : m_path(path), m_file(path, std::ios::binary) {
    std::error_code error;
    m_size = std::filesystem::file_size(path, error);
    if (error || !m_file) {
        failToRead(path);
    }
}

// Holds the next bytes in the window, as many as there are.
bool ByteWindow::cover(std::size_t count) {
    if (m_place >= m_size) {
        return false;
    }
    const std::uint64_t end = std::min<std::uint64_t>(m_size, m_place + count);
    if (m_place < m_begin || end > m_begin + m_window.size()) {
        m_window.resize(static_cast<std::size_t>(std::min<std::uint64_t>(std::max(count, windowBytes), m_size - m_place)));
        m_file.clear();
        m_file.seekg(static_cast<std::streamoff>(m_place));
        m_file.read(m_window.data(), static_cast<std::streamsize>(m_window.size()));
        m_window.resize(static_cast<std::size_t>(m_file.gcount()));
        m_begin = m_place;
    }
    return m_place < m_begin + m_window.size();
}

bool ByteWindow::line(std::string& text) {
    text.clear();
    if (!cover(longestLine)) {
        return false;
    }
    const std::string_view seen = std::string_view(m_window).substr(m_place - m_begin, longestLine);
    const std::size_t end = seen.find('\n');
    const bool ended = end != std::string_view::npos;
    text = seen.substr(0, end);
    m_place += text.size() + (ended ? 1 : 0);
    while (text.ends_with('\r')) {
        text.pop_back();
    }
    return true;
}

bool ByteWindow::bytes(std::size_t count, std::string& bytes) {
    if (count > m_size || m_place > m_size - count) {
        return false;
    }
    if (count == 0) {
        bytes.clear();
        return true;
    }
    if (!cover(count) || m_place + count > m_begin + m_window.size()) {
        return false;
    }
    bytes = m_window.substr(m_place - m_begin, count);
    m_place += count;
    return true;
}

std::string column(const std::string& line, std::size_t first, std::size_t width) {
    if (first >= line.size()) {
        return {};
    }
    const std::string field = line.substr(first, width);
    const std::size_t begin = field.find_first_not_of(" \t");
    return begin == std::string::npos ? "" : field.substr(begin, field.find_last_not_of(" \t") + 1 - begin);
}

std::vector<std::string> fieldsOf(const std::string& line) {
    std::vector<std::string> fields;
    std::size_t start = 0;
    for (std::size_t comma = line.find(','); comma != std::string::npos; comma = line.find(',', start)) {
        fields.push_back(column(line, start, comma - start));
        start = comma + 1;
    }
    fields.push_back(column(line, start, line.size()));
    return fields;
}

std::string upperCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return text;
}

bool toInteger(const std::string& text, std::int64_t& value) {
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() && !text.empty();
}

bool toReal(std::string text, double& value) {
    std::replace_if(text.begin(), text.end(), [](char c) { return c == 'D' || c == 'd'; }, 'E');
    // Three digits leave Fortran no room for the letter: 0.123456-104.
    const std::size_t sign = text.find_last_of("+-");
    if (sign != std::string::npos && sign > 0 && text[sign - 1] != 'E' && text[sign - 1] != 'e') {
        text.insert(sign, "E");
    }
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
    return (error == std::errc{} || error == std::errc::result_out_of_range) && end == text.data() + text.size() && !text.empty();
}

}  // namespace rubble::io
