#include "io/fe/abaqus/fil_records.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "core/base/error.h"
#include "io/base/files.h"

namespace rubble::io {

namespace {

constexpr std::size_t lineLength = 80;
constexpr std::size_t windowBytes = std::size_t{1} << 18;
constexpr std::uint64_t wordsOfBlock = 512;
constexpr std::uint64_t blockBytes = 4 + 4096 + 4;
// Longer records are split into continuations by the writer.
constexpr std::int64_t mostWords = 100'000;
constexpr int endOfIncrement = 2001;

std::uint32_t markAt(const char* bytes, bool big) {
    std::uint32_t mark = 0;
    for (int i = 0; i < 4; ++i) {
        mark = mark << 8 | static_cast<unsigned char>(bytes[big ? i : 3 - i]);
    }
    return mark;
}

std::int64_t binaryInteger(std::array<char, 8> bytes, bool swapped) {
    if (!swapped) {
        // A 4-byte integer in the first half; the other half is not defined.
        std::int32_t value = 0;
        std::memcpy(&value, bytes.data(), sizeof value);
        return value;
    }
    std::reverse(bytes.begin(), bytes.end());
    std::array<std::int32_t, 2> halves{};
    std::memcpy(halves.data(), bytes.data(), sizeof halves);
    return halves[1] != 0 ? halves[1] : halves[0];
}

}  // namespace

std::int64_t FilRecord::integer(std::size_t i) const {
    if (i >= m_words.size()) {
        return 0;
    }
    const Word& word = m_words[i];
    if (word.kind == 'B') {
        return binaryInteger(word.bytes, word.swapped);
    }
    if (word.kind == 'D') {
        const double value = std::bit_cast<double>(word.bytes);
        return std::abs(value) < 9e15 ? static_cast<std::int64_t>(value) : 0;
    }
    return word.kind == 'I' ? std::bit_cast<std::int64_t>(word.bytes) : 0;
}

double FilRecord::real(std::size_t i) const {
    if (i >= m_words.size()) {
        return 0.0;
    }
    std::array<char, 8> bytes = m_words[i].bytes;
    if (m_words[i].swapped) {
        std::reverse(bytes.begin(), bytes.end());
    }
    return m_words[i].kind == 'I' ? static_cast<double>(std::bit_cast<std::int64_t>(bytes)) : std::bit_cast<double>(bytes);
}

std::string FilRecord::text(std::size_t i) const {
    if (i >= m_words.size() || m_words[i].kind == 'D') {
        return {};
    }
    if (m_words[i].kind == 'I') {
        return std::to_string(integer(i));
    }
    std::string text;
    for (const char c : m_words[i].bytes) {
        text += static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e ? ' ' : c;
    }
    return text;
}

std::string FilRecord::textFrom(std::size_t i) const {
    std::string text;
    for (; i < size(); ++i) {
        text += this->text(i);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text.erase(0, text.find_first_not_of(' '));
    return text;
}

bool beginsAsFil(const std::string& head) {
    if (head.size() >= 20 && (markAt(head.data(), false) == 4096 || markAt(head.data(), true) == 4096)) {
        const bool big = markAt(head.data(), true) == 4096;
        std::array<char, 8> key{};
        std::copy(head.begin() + 12, head.begin() + 20, key.begin());
        return binaryInteger(key, big) == 1921;
    }
    const std::size_t star = head.find_first_not_of(" \r\n");
    return star != std::string::npos && head.substr(star, 12).starts_with("*I ") &&
           head.substr(star, 24).find("I 41921") != std::string::npos;
}

FilRecords::FilRecords(const std::string& path) : m_path(path), m_file(path, std::ios::binary) {
    std::error_code error;
    m_bytes = std::filesystem::file_size(path, error);
    if (error || !m_file) {
        failToRead(path);
    }
    std::string head(64, '\0');
    m_file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(m_file.gcount()));
    m_file.clear();
    if (!beginsAsFil(head)) {
        fail("the record 1921 of a results file", "\"" + head.substr(0, 8) + "\"");
    }
    if (head.find_first_not_of(" \r\n") == std::string::npos || head[head.find_first_not_of(" \r\n")] != '*') {
        m_kind = markAt(head.data(), true) == 4096 ? Kind::Big : Kind::Little;
    }
}

void FilRecords::fail(const std::string& expected, const std::string& found) const {
    const std::uint64_t at =
        m_kind == Kind::Ascii ? m_lineBegin + m_column : m_word / wordsOfBlock * blockBytes + 4 + m_word % wordsOfBlock * 8;
    std::string shown = found;
    std::replace_if(
        shown.begin(), shown.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e; }, '?');
    throw ParseError(
        {"fil.broken", "{0}: byte {1} should be {2}, but there is {3}", {m_path, static_cast<std::int64_t>(at), expected, shown}},
        {"fil.broken.remedy", "The file is damaged: copy it again or let the analysis write it again.", {}});
}

void FilRecords::seek(const FilPlace& place) {
    m_cutOff = false;
    if (m_kind == Kind::Ascii) {
        m_nextLine = place.offset;
        m_line.clear();
        m_column = 0;
        if (line()) {
            m_column = std::min<std::size_t>(place.column, m_line.size());
        }
    } else {
        m_word = place.offset;
    }
}

bool FilRecords::next(FilRecord& record) {
    record.key = 0;
    record.m_words.clear();
    return m_kind == Kind::Ascii ? nextAscii(record) : nextBinary(record);
}

bool FilRecords::line() {
    constexpr std::size_t longest = 4 * lineLength;
    const bool covered = m_nextLine >= m_windowBegin && m_nextLine + longest <= m_windowBegin + m_window.size();
    if (!covered && (m_windowBegin + m_window.size() < m_bytes || m_nextLine < m_windowBegin)) {
        m_window.resize(static_cast<std::size_t>(std::min<std::uint64_t>(windowBytes, m_bytes - std::min(m_nextLine, m_bytes))));
        m_file.clear();
        m_file.seekg(static_cast<std::streamoff>(m_nextLine));
        m_file.read(m_window.data(), static_cast<std::streamsize>(m_window.size()));
        m_window.resize(static_cast<std::size_t>(m_file.gcount()));
        m_windowBegin = m_nextLine;
    }
    if (m_nextLine >= m_windowBegin + m_window.size()) {
        return false;
    }
    const std::string_view seen = std::string_view(m_window).substr(m_nextLine - m_windowBegin, longest);
    const std::size_t got = seen.size();
    const std::size_t end = seen.find('\n');
    if (end == std::string_view::npos && got == longest) {
        fail("a line of 80 columns", "a longer one");
    }
    m_lineBegin = m_nextLine;
    m_line = std::string(seen.substr(0, end));
    m_nextLine += std::min(end, got) + (end == std::string_view::npos ? 0 : 1);
    while (m_line.ends_with('\r')) {
        m_line.pop_back();
    }
    // Blanks at the end may have been cut off; of the last line nobody knows whether it is whole.
    if (end != std::string_view::npos) {
        m_line.resize(std::max(m_line.size(), lineLength), ' ');
    }
    m_column = 0;
    return true;
}

int FilRecords::character() {
    while (m_column >= m_line.size()) {
        if (!line()) {
            return -1;
        }
    }
    return static_cast<unsigned char>(m_line[m_column++]);
}

bool FilRecords::take(std::size_t count, std::string& text) {
    text.clear();
    while (text.size() < count) {
        const int c = character();
        if (c < 0) {
            return false;
        }
        text += static_cast<char>(c);
    }
    return true;
}

bool FilRecords::item(FilRecord::Word& word) {
    const int kind = character();
    std::string text;
    if (kind < 0) {
        return false;
    }
    word.kind = static_cast<char>(kind == 'E' ? 'D' : kind);
    if (kind == 'A') {
        if (!take(8, text)) {
            return false;
        }
        std::copy(text.begin(), text.end(), word.bytes.begin());
        return true;
    }
    if (kind == 'I') {
        if (!take(2, text)) {
            return false;
        }
        const std::size_t width = static_cast<std::size_t>((text[0] >= '0' && text[0] <= '9' ? text[0] - '0' : 0) * 10 +
                                                           (text[1] >= '0' && text[1] <= '9' ? text[1] - '0' : 0));
        if (!take(width, text)) {
            return false;
        }
        std::erase(text, ' ');
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc{} || end != text.data() + text.size()) {
            fail("an integer of " + std::to_string(width) + " digits", "\"" + text + "\"");
        }
        word.bytes = std::bit_cast<std::array<char, 8>>(value);
        return true;
    }
    if (kind != 'D' && kind != 'E') {
        fail("an item I, D or A", "\"" + std::string(1, static_cast<char>(kind)) + "\"");
    }
    if (!take(22, text)) {
        return false;
    }
    std::erase(text, ' ');
    std::erase(text, '+');
    std::replace_if(text.begin(), text.end(), [](char c) { return c == 'D' || c == 'd'; }, 'E');
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if ((error != std::errc{} && error != std::errc::result_out_of_range) || end != text.data() + text.size()) {
        fail("a real of 22 columns", "\"" + text + "\"");
    }
    word.bytes = std::bit_cast<std::array<char, 8>>(value);
    return true;
}

bool FilRecords::nextAscii(FilRecord& record) {
    int c = character();
    while (c == ' ') {
        c = character();
    }
    if (c < 0) {
        return false;
    }
    m_begin = {m_lineBegin, static_cast<std::uint32_t>(m_column - 1)};
    if (c != '*') {
        fail("the * of a record", "\"" + std::string(1, static_cast<char>(c)) + "\"");
    }
    FilRecord::Word word;
    if (!item(word)) {
        m_cutOff = true;
        return false;
    }
    record.m_words = {word};
    const std::int64_t length = record.integer(0);
    if (length < 2 || length > mostWords) {
        fail("a record of 2 or more words", std::to_string(length));
    }
    record.m_words.clear();
    for (std::int64_t i = 1; i < length; ++i) {
        if (!item(word)) {
            m_cutOff = true;
            return false;
        }
        record.m_words.push_back(word);
    }
    record.key = static_cast<int>(std::clamp<std::int64_t>(record.integer(0), 0, 100'000));
    record.m_words.erase(record.m_words.begin());
    return true;
}

bool FilRecords::block(std::uint64_t number) {
    if (number == m_blockNumber) {
        return true;
    }
    const std::uint64_t offset = number * blockBytes;
    if (offset + blockBytes > m_bytes) {
        m_cutOff = m_cutOff || offset < m_bytes;
        return false;
    }
    m_block.resize(blockBytes);
    m_file.clear();
    m_file.seekg(static_cast<std::streamoff>(offset));
    m_file.read(m_block.data(), static_cast<std::streamsize>(blockBytes));
    if (static_cast<std::uint64_t>(m_file.gcount()) != blockBytes) {
        return false;
    }
    const bool big = m_kind == Kind::Big;
    if (markAt(m_block.data(), big) != 4096 || markAt(m_block.data() + 4100, big) != 4096) {
        m_word = number * wordsOfBlock;
        fail("a block of 4096 bytes", "a mark of " + std::to_string(markAt(m_block.data(), big)));
    }
    m_blockNumber = number;
    return true;
}

bool FilRecords::word(FilRecord::Word& word) {
    if (!block(m_word / wordsOfBlock)) {
        return false;
    }
    word.kind = 'B';
    word.swapped = m_kind == Kind::Big;
    std::copy_n(m_block.begin() + static_cast<std::ptrdiff_t>(4 + m_word % wordsOfBlock * 8), 8, word.bytes.begin());
    ++m_word;
    return true;
}

bool FilRecords::nextBinary(FilRecord& record) {
    FilRecord::Word word;
    std::int64_t length = 0;
    for (;;) {
        m_begin = {m_word, 0};
        if (!this->word(word)) {
            return false;
        }
        length = binaryInteger(word.bytes, word.swapped);
        if (length != 0) {
            break;
        }
        // Zeros fill a block behind the end of an increment.
        m_word = (m_word + wordsOfBlock - 1) / wordsOfBlock * wordsOfBlock;
    }
    if (length < 2 || length > mostWords) {
        --m_word;
        fail("the length of a record, 2 or more words", std::to_string(length));
    }
    for (std::int64_t i = 1; i < length; ++i) {
        if (!this->word(word)) {
            m_cutOff = true;
            return false;
        }
        record.m_words.push_back(word);
    }
    record.key = static_cast<int>(std::clamp<std::int64_t>(record.integer(0), 0, 100'000));
    record.m_words.erase(record.m_words.begin());
    if (record.key == endOfIncrement) {
        m_word = (m_word + wordsOfBlock - 1) / wordsOfBlock * wordsOfBlock;
    }
    return true;
}

}  // namespace rubble::io
