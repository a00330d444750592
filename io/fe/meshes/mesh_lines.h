#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace rubble::io {

/// The lines of a mesh that is text. A line that ends in a backslash goes on in the next one.
class MeshLines {
public:
    /// Throws WorldError.
    explicit MeshLines(const std::string& path);

    /// The next line without its end, valid until the next call; the last one may have none. @return false at the end of the file
    /// Throws ParseError for a line that is longer than any of a mesh.
    bool next(std::string_view& line);
    /// Of the line that was last given, counted from 1.
    std::uint64_t number() const { return m_number; }
    /// A number of that line. Throws ParseError for what is none or not finite, naming line and text.
    double numberIn(std::string_view text) const;
    /// The file itself, behind the line that was last given.
    std::ifstream& file() { return m_file; }

private:
    bool append();

    std::string m_path;
    std::ifstream m_file;
    std::string m_line;
    std::uint64_t m_number = 0;  ///< of the first line of those put together
    std::uint64_t m_read = 0;
};

}  // namespace rubble::io
