#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace rubble::io {

/// Reads records of a result file of Ansys MAPDL: length in words, flags, data, a closing word; little-endian. Data may be packed:
/// short, by bits or by windows. Not for several threads at once.
class RstRecords {
public:
    /// Throws WorldError.
    explicit RstRecords(const std::string& path);

    std::uint64_t words() const { return m_words; }
    /// The record at a word. @param most  values it may have at most  Throws ParseError with the byte.
    std::vector<std::int64_t> integers(std::uint64_t word, std::uint64_t most);
    std::vector<double> reals(std::uint64_t word, std::uint64_t most);
    /// The word behind a record.
    std::uint64_t next(std::uint64_t word);

private:
    struct Head {
        std::uint64_t words = 0;
        unsigned flags = 0;
    };

    Head head(std::uint64_t word);
    std::string data(std::uint64_t word, const Head& head);
    template <class T>
    std::vector<T> decode(std::uint64_t word, std::uint64_t most);
    [[noreturn]] void fail(std::uint64_t word, const std::string& what) const;

    std::string m_path;
    std::ifstream m_file;
    std::uint64_t m_words = 0;
};

}  // namespace rubble::io
