#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace rubble::io {

/// How a d3plot family stores its words.
struct WordFormat {
    std::int64_t bytes = 4;  ///< 4 or 8
    bool bigEndian = false;

    friend bool operator==(const WordFormat&, const WordFormat&) = default;
};

/// A float of a d3plot word. @param bytes  the word as it lies in the file
double floatOfWord(const unsigned char* bytes, WordFormat format);
std::int64_t integerOfWord(const unsigned char* bytes, WordFormat format);

/// The files of a d3plot family as one row of words, file after file: what does not fit into a file goes on at the beginning of the
/// next one. Sizes are those at the time of opening. One file is open at a time, so that a family of thousands needs no handles;
/// every member may be called from any thread.
class D3plotFamily {
public:
    /// Throws WorldError for files that cannot be asked for their size.
    D3plotFamily(std::vector<std::string> files, WordFormat format);
    ~D3plotFamily();
    D3plotFamily(const D3plotFamily&) = delete;
    D3plotFamily& operator=(const D3plotFamily&) = delete;

    WordFormat format() const { return m_format; }
    const std::string& path() const { return m_files.front(); }
    std::size_t files() const { return m_files.size(); }
    std::int64_t words() const { return m_first.back(); }
    /// Place of a file's first word; of files(): of the end.
    std::int64_t firstWord(std::size_t file) const { return m_first[file]; }
    std::int64_t wordsOf(std::size_t file) const { return m_first[file + 1] - m_first[file]; }
    /// The file a word lies in; the last one for the end.
    std::size_t fileOf(std::int64_t word) const;
    /// For messages: "d3plot03".
    std::string fileName(std::size_t file) const;
    /// For messages: "d3plot03, byte 1,024".
    std::string placeOf(std::int64_t word) const;

    /// Reads words from a place on; they must lie within the family. Throws WorldError, and ParseError for a file that has become
    /// shorter.
    void readFloats(std::int64_t word, std::span<double> values) const;
    void readIntegers(std::int64_t word, std::span<std::int64_t> values) const;
    double readFloat(std::int64_t word) const;
    std::int64_t readInteger(std::int64_t word) const;
    /// The bytes of some words, as text.
    std::string readText(std::int64_t word, std::int64_t words) const;

private:
    class Handle;

    void readBytes(std::int64_t word, std::span<unsigned char> bytes) const;
    template <class Value>
    void readWords(std::int64_t word, std::span<Value> values, Value (*valueOf)(const unsigned char*, WordFormat)) const;
    std::shared_ptr<const Handle> handleOf(std::size_t file) const;

    std::vector<std::string> m_files;
    std::vector<std::int64_t> m_first;  ///< [files + 1]
    WordFormat m_format;
    mutable std::mutex m_mutex;
    mutable std::size_t m_opened = 0;
    mutable std::shared_ptr<const Handle> m_handle;
};

/// Whether a file is the root of a family, by its content.
bool isD3plotRoot(const std::string& path);

/// Files of the family that a file belongs to, the root first, then by number; ends at the first number that is missing. A file
/// that is a root itself is nobody's member. See FeFormat::members.
std::vector<std::string> d3plotMembers(const std::string& path);

/// Roots of an adaptive run that a file belongs to: d3plot, then those of its later meshes, d3plotaa, d3plotab, ...; of any other
/// run its root alone.
std::vector<std::string> d3plotRoots(const std::string& path);

/// Numbered files that belong to a root but lie beyond a missing number: names without folder, sorted.
std::vector<std::string> d3plotLeftBehind(const std::string& root, std::size_t members);

}  // namespace rubble::io
