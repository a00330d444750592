#include "io/site/exif_tags.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <sstream>

namespace rubble::io {

namespace {

constexpr std::uint64_t noPlace = std::numeric_limits<std::uint64_t>::max();

/// A part of a file.
class FilePart {
public:
    FilePart(std::istream& file, std::uint64_t base, std::uint64_t length) : m_file(file), m_base(base), m_length(length) {}

    /// Bytes at a place; nothing if they are not all there.
    std::optional<std::string> bytes(std::uint64_t at, std::uint64_t count) const {
        if (at > m_length || count > m_length - at) {
            return std::nullopt;
        }
        std::string read(count, '\0');
        m_file.clear();
        m_file.seekg(static_cast<std::streamoff>(m_base + at));
        m_file.read(read.data(), static_cast<std::streamsize>(count));
        return m_file.gcount() == static_cast<std::streamsize>(count) ? std::optional(read) : std::nullopt;
    }
    std::uint64_t length() const { return m_length; }

private:
    std::istream& m_file;
    std::uint64_t m_base;
    std::uint64_t m_length;
};

std::uint64_t numberIn(std::string_view bytes, std::size_t at, std::size_t size, bool big) {
    std::uint64_t number = 0;
    for (std::size_t k = 0; k < size; ++k) {
        const std::size_t from = big ? at + k : at + size - 1 - k;
        number = number << 8 | static_cast<unsigned char>(bytes[from]);
    }
    return number;
}

/// Bytes of a value by its type: byte, text, short, long, fraction, and the same with signs; single and double precision.
constexpr std::array<std::size_t, 13> typeSizes{0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8};

double valueIn(std::string_view bytes, std::size_t at, std::uint64_t type, bool big) {
    const std::size_t size = typeSizes[type];
    const std::uint64_t raw = numberIn(bytes, at, size, big);
    switch (type) {
        case 5:
            return static_cast<double>(numberIn(bytes, at, 4, big)) / static_cast<double>(numberIn(bytes, at + 4, 4, big));
        case 6:
            return static_cast<std::int8_t>(raw);
        case 8:
            return static_cast<std::int16_t>(raw);
        case 9:
            return static_cast<std::int32_t>(raw);
        case 10:
            return static_cast<double>(static_cast<std::int32_t>(numberIn(bytes, at, 4, big))) /
                   static_cast<std::int32_t>(numberIn(bytes, at + 4, 4, big));
        case 11:
            return std::bit_cast<float>(static_cast<std::uint32_t>(raw));
        case 12:
            return std::bit_cast<double>(raw);
        default:
            return static_cast<double>(raw);
    }
}

ExifEntry entryOf(const std::string& bytes, std::uint64_t type, bool big) {
    ExifEntry entry;
    if (type == 2) {
        entry.text = bytes.substr(0, bytes.find('\0'));
        while (!entry.text.empty() && entry.text.back() == ' ') {
            entry.text.pop_back();
        }
        return entry;
    }
    for (std::size_t at = 0; at + typeSizes[type] <= bytes.size(); at += typeSizes[type]) {
        const double value = valueIn(bytes, at, type, big);
        if (std::isfinite(value)) {
            entry.numbers.push_back(value);
        }
    }
    return entry;
}

/// Takes one directory of a block. False if it is not there.
bool takeDirectory(const FilePart& part, std::uint64_t at, ExifDirectory which, bool big, ExifTags& tags) {
    constexpr std::size_t entrySize = 12;
    constexpr std::uint64_t bytesMost = 65536;  // of one value: what is asked for is far shorter
    const auto head = part.bytes(at, 2);
    if (!head) {
        return false;
    }
    const std::uint64_t count = numberIn(*head, 0, 2, big);
    for (std::uint64_t k = 0; k < count; ++k) {
        const auto entry = part.bytes(at + 2 + entrySize * k, entrySize);
        if (!entry) {
            return k > 0;
        }
        const std::uint64_t type = numberIn(*entry, 2, 2, big);
        if (type == 0 || type >= typeSizes.size()) {
            continue;
        }
        const std::uint64_t size = numberIn(*entry, 4, 4, big) * typeSizes[type];
        if (size == 0 || size > bytesMost) {
            continue;
        }
        const auto value = size <= 4 ? std::optional(entry->substr(8, size)) : part.bytes(numberIn(*entry, 8, 4, big), size);
        if (value) {
            tags.try_emplace({which, static_cast<int>(numberIn(*entry, 0, 2, big))}, entryOf(*value, type, big));
        }
    }
    return true;
}

ExifReading tagsOf(const FilePart& part) {
    ExifReading reading{ExifReading::State::Damaged, {}};
    const auto head = part.bytes(0, 8);
    const bool big = head && head->starts_with("MM");
    if (!head || (!big && !head->starts_with("II"))) {
        return reading;
    }
    constexpr std::uint64_t plainTiff = 42;
    constexpr std::uint64_t bigTiff = 43;
    const std::uint64_t mark = numberIn(*head, 2, 2, big);
    if (mark == bigTiff) {
        reading.state = ExifReading::State::NotRead;
        return reading;
    }
    if (mark != plainTiff || !takeDirectory(part, numberIn(*head, 4, 4, big), ExifDirectory::First, big, reading.tags)) {
        return reading;
    }
    constexpr int exifPointer = 0x8769;
    constexpr int gpsPointer = 0x8825;
    for (const auto& [tag, which] : {std::pair(exifPointer, ExifDirectory::Exif), std::pair(gpsPointer, ExifDirectory::Gps)}) {
        const auto found = reading.tags.find({ExifDirectory::First, tag});
        if (found != reading.tags.end() && found->second.numbers.size() == 1 && found->second.numbers[0] >= 0.0) {
            takeDirectory(part, static_cast<std::uint64_t>(found->second.numbers[0]), which, big, reading.tags);
        }
    }
    reading.state = ExifReading::State::Read;
    return reading;
}

/// Where a block lies in a file.
struct BlockPlace {
    std::uint64_t at = noPlace;
    std::uint64_t length = 0;
    bool otherwise = false;  ///< it lies there in a way that is not read
};

BlockPlace placeInJpeg(const FilePart& file) {
    constexpr std::string_view mark("Exif\0\0", 6);
    std::uint64_t at = 2;
    for (auto head = file.bytes(at, 4); head; head = file.bytes(at, 4)) {
        const auto kind = static_cast<unsigned char>((*head)[1]);
        const std::uint64_t length = numberIn(*head, 2, 2, true);
        constexpr unsigned char scan = 0xda;
        constexpr unsigned char end = 0xd9;
        constexpr unsigned char application = 0xe1;
        if (static_cast<unsigned char>((*head)[0]) != 0xff || kind == scan || kind == end) {
            break;
        }
        if (kind == 0xff) {  // bytes may be filled up
            ++at;
            continue;
        }
        if (kind == application && length >= 8 && file.bytes(at + 4, 6) == mark) {
            return {at + 10, length - 8};
        }
        at += 2 + length;
    }
    return {};
}

BlockPlace placeInPng(const FilePart& file) {
    constexpr std::string_view profile = "Raw profile type ";
    constexpr std::size_t kindLength = 4;
    BlockPlace place;
    std::uint64_t at = 8;
    for (auto head = file.bytes(at, 8); head; head = file.bytes(at, 8)) {
        const std::uint64_t length = numberIn(*head, 0, 4, true);
        const std::string kind = head->substr(4);
        if (kind == "eXIf") {
            return {at + 8, length};
        }
        // A custom from before there was a chunk for it: EXIF in hexadecimal digits, often packed.
        if (kind == "zTXt" || kind == "tEXt" || kind == "iTXt") {
            const std::string name = file.bytes(at + 8, profile.size() + kindLength).value_or("");
            place.otherwise = place.otherwise || (name.starts_with(profile) && (name.ends_with("exif") || name.ends_with("APP1")));
        }
        at += 12 + length;
    }
    return place;
}

}  // namespace

ExifReading exifOfPicture(std::istream& file) {
    file.clear();
    file.seekg(0, std::ios::end);
    const FilePart whole(file, 0, static_cast<std::uint64_t>(std::max<std::streamoff>(0, file.tellg())));
    const std::string head = whole.bytes(0, 8).value_or("");
    if (head.starts_with("II") || head.starts_with("MM")) {
        return tagsOf(whole);
    }
    BlockPlace place;
    if (head.starts_with("\xff\xd8")) {
        place = placeInJpeg(whole);
    } else if (head == "\x89PNG\r\n\x1a\n") {
        place = placeInPng(whole);
    } else {
        place.otherwise = true;
    }
    if (place.at == noPlace) {
        return {place.otherwise ? ExifReading::State::NotRead : ExifReading::State::None, {}};
    }
    return tagsOf(FilePart(file, place.at, std::min(place.length, whole.length() - std::min(whole.length(), place.at))));
}

ExifReading exifOfBlock(const std::string& block) {
    std::istringstream memory(block);
    return tagsOf(FilePart(memory, 0, block.size()));
}

}  // namespace rubble::io
