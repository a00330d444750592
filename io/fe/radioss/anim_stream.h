#pragma once

#include <zlib.h>

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

namespace rubble::io {

/// Reads a big-endian file of packed values from front to back, plain or gzip-packed. Nothing is allocated for more than the file
/// can hold. All reads throw ParseError naming file, byte, what was to be read, and how much of it there is.
class AnimStream {
public:
    /// Throws WorldError if the file cannot be opened.
    explicit AnimStream(const std::string& path);

    const std::string& path() const { return m_path; }
    /// Byte of the unpacked file that comes next.
    std::int64_t place() const { return m_place; }

    std::int64_t integer(const char* what);
    double real(const char* what);
    std::vector<std::int64_t> integers(std::size_t count, const char* what);
    std::vector<double> reals(std::size_t count, const char* what);
    std::vector<std::uint8_t> bytes(std::size_t count, const char* what);
    /// A text of fixed length, up to its first zero.
    std::string text(std::size_t length, const char* what);
    /// Leaves out as many bytes as the product of the factors.
    void skip(std::initializer_list<std::size_t> factors, const char* what);

private:
    void require(std::size_t bytes, const char* what) const;
    [[noreturn]] void failCut(std::int64_t needed, const char* what) const;
    void take(unsigned char* to, std::size_t bytes, const char* what);

    std::string m_path;
    std::unique_ptr<gzFile_s, int (*)(gzFile)> m_file;
    std::int64_t m_place = 0;
    std::int64_t m_most = 0;  ///< the longest that the unpacked file can be
};

}  // namespace rubble::io
