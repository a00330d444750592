#include "io/fe/meshes/mesh_lines.h"

#include <charconv>
#include <cmath>

#include "io/base/file_words.h"
#include "io/base/files.h"

namespace rubble::io {

namespace {

/// Bytes; a face of the most corners takes less.
constexpr std::size_t lineMax = std::size_t{1} << 20;

}  // namespace

MeshLines::MeshLines(const std::string& path) : m_path(path), m_file(path, std::ios::binary) {
    if (!m_file) {
        failToRead(path);
    }
}

bool MeshLines::append() {
    // As std::getline(), but it would take a file without ends of lines into memory whole.
    std::streambuf& buffer = *m_file.rdbuf();
    int byte = buffer.sbumpc();
    if (byte == std::char_traits<char>::eof()) {
        return false;
    }
    ++m_read;
    for (; byte != std::char_traits<char>::eof() && byte != '\n'; byte = buffer.sbumpc()) {
        m_line.push_back(static_cast<char>(byte));
        if (m_line.size() > lineMax) {
            refuseContent({"surroundings.long_line",
                           "{0}, line {1} is longer than any line of a mesh",
                           {m_path, static_cast<std::int64_t>(m_read)}},
                          "Check that the file is what its name says, and export the mesh anew.");
        }
    }
    if (!m_line.empty() && m_line.back() == '\r') {
        m_line.pop_back();
    }
    return true;
}

bool MeshLines::next(std::string_view& line) {
    m_line.clear();
    if (!append()) {
        return false;
    }
    m_number = m_read;
    while (!m_line.empty() && m_line.back() == '\\') {
        m_line.back() = ' ';
        if (!append()) {
            break;
        }
    }
    line = m_line;
    return true;
}

double MeshLines::numberIn(std::string_view text) const {
    if (text.starts_with('+')) {
        text.remove_prefix(1);
    }
    double value = 0.0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end.ec != std::errc{} || end.ptr != text.data() + text.size() || !std::isfinite(value)) {
        refuseContent({"surroundings.no_number",
                       "{0}, line {1}: \"{2}\" stands where a number should",
                       {m_path, static_cast<std::int64_t>(m_number), text.substr(0, 60)}},
                      "Export the mesh anew, with a point as decimal sign.");
    }
    return value;
}

}  // namespace rubble::io
