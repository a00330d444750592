#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace rubble::io {

/// Reads a file of lines, or of lines and bytes, from any place on, through a window of fixed size. Not for several threads at
/// once.
class ByteWindow {
public:
    /// Throws WorldError.
    explicit ByteWindow(const std::string& path);

    const std::string& path() const { return m_path; }
    std::uint64_t size() const { return m_size; }
    std::uint64_t place() const { return m_place; }
    void seek(std::uint64_t place) { m_place = place; }
    void skip(std::uint64_t bytes) { m_place += bytes; }

    /// The next line without its end. @return false at the end of the file
    /// Lines of more than 4,096 bytes come in pieces: a text that a reader knows has none.
    bool line(std::string& text);
    /// The next bytes. @return false if there are fewer
    bool bytes(std::size_t count, std::string& bytes);

private:
    bool cover(std::size_t count);

    std::string m_path;
    std::ifstream m_file;
    std::uint64_t m_size = 0;
    std::uint64_t m_place = 0;
    std::uint64_t m_begin = 0;  ///< of the window
    std::string m_window;
};

/// A field of fixed columns of a line, without blanks around it; empty where the line ends before.
std::string column(const std::string& line, std::size_t first, std::size_t width);
/// The fields of a line between commas, without blanks around them. Never empty.
std::vector<std::string> fieldsOf(const std::string& line);
/// With letters a to z as capitals, whatever the locale.
std::string upperCase(std::string text);
/// The number in a field. @return false if it is none
bool toInteger(const std::string& text, std::int64_t& value);
/// The same for reals, as Fortran writes them: exponents D, and without a letter.
bool toReal(std::string text, double& value);

}  // namespace rubble::io
