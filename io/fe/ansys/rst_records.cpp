#include "io/fe/ansys/rst_records.h"

#include <cstring>
#include <filesystem>
#include <type_traits>

#include "core/base/error.h"
#include "io/base/files.h"

namespace rubble::io {

namespace {

constexpr unsigned integerFlag = 0x80, shortFlag = 0x40, packedFlag = 0x20, windowFlag = 0x10, bitFlag = 0x08;

/// Takes values of one width from the data of a record.
class Values {
public:
    Values(const std::string& data, bool integer, bool narrow) : m_data(data), m_integer(integer), m_narrow(narrow) {}

    std::size_t width() const { return (m_integer ? 4 : 8) / (m_narrow ? 2 : 1); }
    bool left(std::size_t bytes) const { return m_at + bytes <= m_data.size(); }

    double value() {
        const char* at = m_data.data() + m_at;
        m_at += width();
        if (m_integer) {
            return m_narrow ? static_cast<double>(as<std::int16_t>(at)) : static_cast<double>(as<std::int32_t>(at));
        }
        return m_narrow ? static_cast<double>(as<float>(at)) : as<double>(at);
    }
    std::int64_t word() {
        m_at += 4;
        return as<std::int32_t>(m_data.data() + m_at - 4);
    }

private:
    template <class T>
    static T as(const char* at) {
        T value;
        std::memcpy(&value, at, sizeof value);
        return value;
    }

    const std::string& m_data;
    bool m_integer, m_narrow;
    std::size_t m_at = 0;
};

// @return false where the data ends before
bool unpackBits(Values& values, std::vector<double>& result) {
    const auto bits = static_cast<std::uint32_t>(values.word());
    for (std::size_t i = 0; i < result.size() && i < 32; ++i) {
        if ((bits >> i & 1u) != 0) {
            if (!values.left(values.width())) {
                return false;
            }
            result[i] = values.value();
        }
    }
    return true;
}

// A place above 0 is that of one value; else a window begins at its opposite: values, or one value repeated where the length is
// negative.
bool unpackWindows(Values& values, std::vector<double>& result) {
    const std::int64_t windows = values.word();
    const auto size = static_cast<std::int64_t>(result.size());
    for (std::int64_t w = 0; w < windows; ++w) {
        if (!values.left(4)) {
            return false;
        }
        const std::int64_t place = values.word();
        if (place > 0 && (place >= size || !values.left(values.width()))) {
            return false;
        }
        if (place > 0) {
            result[static_cast<std::size_t>(place)] = values.value();
            continue;
        }
        const std::int64_t length = values.left(4) ? values.word() : size + 1;
        const std::int64_t count = length < 0 ? -length : length;
        const std::size_t bytes = length > 0 ? static_cast<std::size_t>(length) * values.width() : values.width();
        if (count > size || -place > size - count || !values.left(bytes)) {
            return false;
        }
        const double constant = length > 0 ? 0.0 : values.value();
        for (std::int64_t i = 0; i < count; ++i) {
            result[static_cast<std::size_t>(i - place)] = length > 0 ? values.value() : constant;
        }
    }
    return true;
}

}  // namespace

RstRecords::RstRecords(const std::string& path) : m_path(path), m_file(path, std::ios::binary) {
    std::error_code error;
    m_words = std::filesystem::file_size(path, error) / 4;
    if (error || !m_file) {
        failToRead(path);
    }
}

void RstRecords::fail(std::uint64_t word, const std::string& what) const {
    const auto byte = static_cast<std::int64_t>(std::min<std::uint64_t>(word, INT64_MAX / 4) * 4);
    throw ParseError(
        {"rst.broken", "{0}: the record at byte {1} {2}", {m_path, byte, what}},
        {"rst.broken.remedy", "The file is damaged or not yet whole: copy it again or let the analysis write it again.", {}});
}

RstRecords::Head RstRecords::head(std::uint64_t word) {
    if (m_words < 3 || word > m_words - 3) {
        fail(word, "lies behind the end of the file (" + std::to_string(m_words) + " words)");
    }
    std::uint32_t raw[2] = {};
    m_file.clear();
    m_file.seekg(static_cast<std::streamoff>(word * 4));
    m_file.read(reinterpret_cast<char*>(raw), sizeof raw);
    if (raw[0] > m_words - word - 3) {
        fail(word, "should have " + std::to_string(raw[0]) + " words, more than the file has left");
    }
    return {raw[0], raw[1] >> 24};
}

std::string RstRecords::data(std::uint64_t word, const Head& head) {
    std::string bytes(head.words * 4, '\0');
    m_file.clear();
    m_file.seekg(static_cast<std::streamoff>((word + 2) * 4));
    m_file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return bytes;
}

std::uint64_t RstRecords::next(std::uint64_t word) {
    return word + head(word).words + 3;
}

template <class T>
std::vector<T> RstRecords::decode(std::uint64_t word, std::uint64_t most) {
    const Head about = head(word);
    if ((about.flags & packedFlag) != 0) {
        throw ParseError({"rst.packed", "{0}: the record at byte {1} is compressed", {m_path, static_cast<std::int64_t>(word * 4)}},
                         {"rst.packed.remedy", "Let the analysis write it without compression (/FCOMP,RST,0).", {}});
    }
    const bool integer = (about.flags & integerFlag) != 0;
    if (std::is_integral_v<T> && !integer) {
        fail(word, "should hold integers, but its flags say reals");
    }
    const std::string bytes = data(word, about);
    Values values(bytes, integer, (about.flags & shortFlag) != 0);
    std::vector<double> result;
    bool whole = true;
    if ((about.flags & (bitFlag | windowFlag)) != 0) {
        const std::int64_t count = values.left(8) ? values.word() : -1;
        if (count < 0 || static_cast<std::uint64_t>(count) > most) {
            fail(word, "should have at most " + std::to_string(most) + " values, but says " + std::to_string(count));
        }
        result.resize(static_cast<std::size_t>(count), 0.0);
        whole = (about.flags & bitFlag) != 0 ? unpackBits(values, result) : unpackWindows(values, result);
    } else {
        if (bytes.size() / values.width() > most) {
            fail(word, "should have at most " + std::to_string(most) + " values, but has " +
                           std::to_string(bytes.size() / values.width()));
        }
        while (values.left(values.width())) {
            result.push_back(values.value());
        }
    }
    if (!whole) {
        fail(word, "ends inside its values");
    }
    return {result.begin(), result.end()};
}

std::vector<std::int64_t> RstRecords::integers(std::uint64_t word, std::uint64_t most) {
    return decode<std::int64_t>(word, most);
}

std::vector<double> RstRecords::reals(std::uint64_t word, std::uint64_t most) {
    return decode<double>(word, most);
}

}  // namespace rubble::io
