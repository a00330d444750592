#include "io/fe/vtk/legacy_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <type_traits>
#include <utility>

#include "core/base/error.h"
#include "io/base/files.h"

namespace rubble::io {

namespace {

using Kind = NumberType::Kind;

// vtkIdType was always written as int.
constexpr std::array<std::pair<std::string_view, NumberType>, 14> typeNames{{{"float", {Kind::Real, 4}},
                                                                             {"double", {Kind::Real, 8}},
                                                                             {"char", {Kind::Signed, 1}},
                                                                             {"signed_char", {Kind::Signed, 1}},
                                                                             {"unsigned_char", {Kind::Unsigned, 1}},
                                                                             {"short", {Kind::Signed, 2}},
                                                                             {"unsigned_short", {Kind::Unsigned, 2}},
                                                                             {"int", {Kind::Signed, 4}},
                                                                             {"unsigned_int", {Kind::Unsigned, 4}},
                                                                             {"long", {Kind::Signed, 8}},
                                                                             {"unsigned_long", {Kind::Unsigned, 8}},
                                                                             {"vtktypeint64", {Kind::Signed, 8}},
                                                                             {"vtktypeuint64", {Kind::Unsigned, 8}},
                                                                             {"vtkidtype", {Kind::Signed, 4}}}};

bool isText(const std::string& type) {
    return type == "string" || type == "utf8_string";
}

int hexDigit(char c) {
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

}  // namespace

LegacyText::LegacyText(const std::string& path) : m_path(path) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    std::ifstream file(path, std::ios::binary);
    if (error || !file) {
        failToRead(path);
    }
    m_text.resize(static_cast<std::size_t>(size));
    file.read(m_text.data(), static_cast<std::streamsize>(m_text.size()));
    m_text.resize(static_cast<std::size_t>(file.gcount()));
    m_left = m_text;
}

void LegacyText::fail(const std::string& why) const {
    throw ParseError({"vtk.legacy", "{0} cannot be read as a VTK grid: before byte {1} {2}", {m_path, place(), why}},
                     {"vtk.read.remedy", "The file is damaged or not yet whole: copy it again or write it again.", {}});
}

void LegacyText::failCut(const std::string& what) const {
    throw ParseError({"vtk.cut", "{0} is cut off: it ends at byte {1} within {2}", {m_path, m_text.size(), what}},
                     {"vtk.read.remedy", "The file is damaged or not yet whole: copy it again or write it again.", {}});
}

std::string LegacyText::word() {
    return std::string(takeWord(m_left));
}

std::string LegacyText::line() {
    const std::size_t end = std::min(m_left.find('\n'), m_left.size());
    std::string text(m_left.substr(0, end));
    m_left.remove_prefix(std::min(end + 1, m_left.size()));
    while (!text.empty() && (text.back() == '\r' || text.back() == ' ')) {
        text.pop_back();
    }
    return text;
}

std::uint64_t LegacyText::count(const char* what) {
    const std::string text = word();
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty()) {
        failCut(what);
    }
    if (error != std::errc{} || end != text.data() + text.size()) {
        fail("\"" + text.substr(0, 40) + "\" is no number of " + what);
    }
    return value;
}

NumberType LegacyText::typeOf(const std::string& type) const {
    std::string lower = type;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    for (const auto& [name, number] : typeNames) {
        if (name == lower) {
            return number;
        }
    }
    fail("\"" + type.substr(0, 40) + "\" is no type of numbers");
}

// Bytes stand behind the end of the line of their heading.
std::string_view LegacyText::bytes(std::uint64_t count, std::size_t each, const std::string& what) {
    line();
    if (count > m_left.size() / each) {
        failCut(what);
    }
    const std::string_view list = m_left.substr(0, static_cast<std::size_t>(count * each));
    m_left.remove_prefix(list.size());
    return list;
}

std::vector<std::int64_t> LegacyText::bits(std::uint64_t count, const std::string& what) {
    const std::string_view packed = bytes(count / 8 + (count % 8 == 0 ? 0 : 1), 1, what);
    std::vector<std::int64_t> list(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < list.size(); ++i) {
        list[i] = static_cast<unsigned char>(packed[i / 8]) >> (7 - i % 8) & 1;
    }
    return list;
}

template <class T>
std::vector<T> LegacyText::numbers(std::uint64_t count, const std::string& type, const std::string& what) {
    if (m_binary && type == "bit") {
        const std::vector<std::int64_t> list = bits(count, what);
        return {list.begin(), list.end()};
    }
    if (m_binary) {
        const NumberType number = typeOf(type);
        if constexpr (std::is_same_v<T, double>) {
            return realsIn(bytes(count, number.bytes, what), number, true);
        } else {
            return integersIn(bytes(count, number.bytes, what), number, true);
        }
    }
    // A number and what parts it from the next take two bytes.
    if (count > m_left.size() / 2 + 1) {
        failCut(what);
    }
    std::vector<T> list(static_cast<std::size_t>(count));
    for (T& value : list) {
        bool found = false;
        if constexpr (std::is_same_v<T, double>) {
            found = takeReal(m_left, value);
        } else {
            found = takeInteger(m_left, value);
        }
        if (!found && m_left.empty()) {
            failCut(what);
        }
        if (!found) {
            fail("\"" + word().substr(0, 40) + "\" among " + what + " is no number");
        }
    }
    return list;
}

std::vector<double> LegacyText::reals(std::uint64_t count, const std::string& type, const std::string& what) {
    return numbers<double>(count, type, what);
}

std::vector<std::int64_t> LegacyText::integers(std::uint64_t count, const std::string& type, const std::string& what) {
    return numbers<std::int64_t>(count, type, what);
}

void LegacyText::skip(std::uint64_t count, const std::string& type, const std::string& what) {
    if (isText(type)) {
        skipTexts(count, what);
    } else if (m_binary) {
        type == "bit" ? bytes(count / 8 + (count % 8 == 0 ? 0 : 1), 1, what) : bytes(count, typeOf(type).bytes, what);
    } else {
        for (std::uint64_t i = 0; i < count; ++i) {
            if (takeWord(m_left).empty()) {
                failCut(what);
            }
        }
    }
}

// A text takes a line, or begins with its length: two bits that say how many bytes the length takes, and the length.
void LegacyText::skipTexts(std::uint64_t count, const std::string& what) {
    line();
    for (std::uint64_t i = 0; i < count; ++i) {
        if (m_left.empty()) {
            failCut(what);
        }
        if (!m_binary) {
            line();
            continue;
        }
        const std::size_t lengthBytes = std::size_t{8} >> (static_cast<unsigned char>(m_left.front()) >> 6);
        if (lengthBytes > m_left.size()) {
            failCut(what);
        }
        std::uint64_t length = static_cast<unsigned char>(m_left.front()) & 0x3fu;
        for (std::size_t b = 1; b < lengthBytes; ++b) {
            length = length << 8 | static_cast<unsigned char>(m_left[b]);
        }
        if (length > m_left.size() - lengthBytes) {
            failCut(what);
        }
        m_left.remove_prefix(lengthBytes + static_cast<std::size_t>(length));
    }
}

std::string legacyName(const std::string& written) {
    std::string name;
    for (std::size_t i = 0; i < written.size(); ++i) {
        const int high = written[i] == '%' && i + 2 < written.size() ? hexDigit(written[i + 1]) : -1;
        const int low = high >= 0 ? hexDigit(written[i + 2]) : -1;
        if (low >= 0) {
            name.push_back(static_cast<char>(high * 16 + low));
            i += 2;
        } else {
            name.push_back(written[i]);
        }
    }
    return name;
}

}  // namespace rubble::io
