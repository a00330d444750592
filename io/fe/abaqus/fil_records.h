#pragma once

#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace rubble::io {

/// A place in a results file from which records can be read.
struct FilPlace {
    std::uint64_t offset = 0;  ///< binary: word; ASCII: byte of the line's beginning
    std::uint32_t column = 0;  ///< ASCII only
};

/// The key of the record that an increment begins with.
constexpr int filIncrementKey = 2000;

/// One record of an Abaqus results file: its key and what follows.
class FilRecord {
public:
    int key = 0;

    std::size_t size() const { return m_words.size(); }
    /// Attributes after the key, 0-based; 0 or empty where there are fewer.
    std::int64_t integer(std::size_t i) const;
    double real(std::size_t i) const;
    std::string text(std::size_t i) const;
    /// The last texts joined, without trailing blanks.
    std::string textFrom(std::size_t i) const;

private:
    friend class FilRecords;
    struct Word {
        char kind = 'B';              ///< I, D, A as written; B: eight bytes whose kind the reader knows
        std::array<char, 8> bytes{};  ///< of an int64, a double or a text
        bool swapped = false;
    };
    std::vector<Word> m_words;
};

/// Reads the records of an Abaqus results file (.fil) one after another, ASCII or binary of either byte order. Layout after the
/// Abaqus user's guide, "Results file output format".
class FilRecords {
public:
    /// Throws WorldError, ParseError for a file that is neither.
    explicit FilRecords(const std::string& path);

    /// The next record. @return false at the end of the file. Throws ParseError with the byte at which it is wrong; a file that
    /// ends inside a record ends before it, see cutOff().
    bool next(FilRecord& record);
    /// True once the file turned out to end inside a record.
    bool cutOff() const { return m_cutOff; }
    /// Where the record that next() gave last begins.
    FilPlace place() const { return m_begin; }
    void seek(const FilPlace& place);

private:
    enum class Kind { Ascii, Little, Big };

    bool nextAscii(FilRecord& record);
    bool nextBinary(FilRecord& record);
    bool line();
    int character();
    bool take(std::size_t count, std::string& text);
    bool item(FilRecord::Word& word);
    bool word(FilRecord::Word& word);
    bool block(std::uint64_t number);
    [[noreturn]] void fail(const std::string& expected, const std::string& found) const;

    std::string m_path;
    std::ifstream m_file;
    std::uint64_t m_bytes = 0;
    Kind m_kind = Kind::Ascii;
    FilPlace m_begin;
    bool m_cutOff = false;
    /// ASCII: one line, without its end and padded to 80 columns.
    std::string m_window;
    std::uint64_t m_windowBegin = 0;
    std::string m_line;
    std::uint64_t m_lineBegin = 0, m_nextLine = 0;
    std::size_t m_column = 0;
    /// Binary: one physical record of 512 words.
    std::vector<char> m_block;
    std::uint64_t m_blockNumber = ~std::uint64_t{0}, m_word = 0;
};

/// True if a file begins as a results file does. @param head  its first bytes
bool beginsAsFil(const std::string& head);

}  // namespace rubble::io
