#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace rubble::io {

static_assert(std::endian::native == std::endian::little, "numbers of clouds are taken as they lie in memory");

/// A number that lies at some byte, little end first.
template <class Number>
Number littleAt(const unsigned char* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return number;
}

/// A file that is read at any place.
class CloudFile {
public:
    /// Throws WorldError (no file that may be read), ParseError (empty).
    explicit CloudFile(const std::string& path);
    ~CloudFile();
    CloudFile(const CloudFile&) = delete;
    CloudFile& operator=(const CloudFile&) = delete;

    const std::string& path() const { return m_path; }
    std::uint64_t size() const { return m_size; }
    /// Reads as many bytes as there are from a place. @return how many. Throws WorldError.
    std::size_t readSome(std::uint64_t at, unsigned char* target, std::size_t count) const;
    /// Reads them all. Throws ParseError where the file ends before, WorldError.
    void read(std::uint64_t at, unsigned char* target, std::size_t count) const;
    /// The same as bytes of their own; the file is asked first whether it is so long.
    std::vector<unsigned char> bytes(std::uint64_t at, std::uint64_t count) const;
    /// Throws ParseError: the file ends before what it promises.
    [[noreturn]] void failCut() const;

private:
    std::string m_path;
    int m_handle = -1;
    std::uint64_t m_size = 0;
};

}  // namespace rubble::io
