#include "io/fe/vtk/xml_arrays.h"

#include <lz4.h>
#include <lzma.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/error.h"
#include "io/base/base64.h"
#include "io/base/files.h"
#include "io/base/trimmed.h"

namespace rubble::io {

namespace {

constexpr std::size_t chunk = std::size_t{1} << 20;
constexpr std::string_view appendedTag = "<AppendedData";
constexpr std::string_view appendedClose = "</AppendedData>";
// What the best of each can make of a byte; more is asked for by damage.
constexpr std::uint64_t bestZlib = 1100, bestLz4 = 260, bestLzma = 16000;
constexpr std::uint64_t lzmaMemory = std::uint64_t{128} << 20;

}  // namespace

XmlArrays::XmlArrays(const std::string& path) : m_path(path), m_file(path, std::ios::binary | std::ios::ate) {
    if (!m_file || m_file.tellg() < 0) {
        failToRead(path);
    }
    m_size = static_cast<std::uint64_t>(m_file.tellg());
    readText();
    readSettings();
}

void XmlArrays::fail(const std::string& why) const {
    throw ParseError({"vtk.read", "{0} cannot be read as a VTK grid: {1}", {m_path, why}},
                     {"vtk.read.remedy", "The file is damaged or not yet whole: copy it again or write it again.", {}});
}

void XmlArrays::failArray(pugi::xml_node array, const std::string& why) const {
    throw ParseError({"vtk.array", "{0}: the array {1} {2}", {m_path, array.attribute("Name").as_string("(unnamed)"), why}},
                     {"vtk.read.remedy", "The file is damaged or not yet whole: copy it again or write it again.", {}});
}

// Up to appended data, which is no XML where it is raw; its end shows that the file is whole.
void XmlArrays::readText() {
    m_file.seekg(0);
    std::size_t tag = std::string::npos;
    while (m_text.size() < m_size && tag == std::string::npos) {
        const std::size_t before = m_text.size();
        m_text.resize(static_cast<std::size_t>(std::min<std::uint64_t>(before + chunk, m_size)));
        m_file.read(m_text.data() + before, static_cast<std::streamsize>(m_text.size() - before));
        if (m_file.gcount() != static_cast<std::streamsize>(m_text.size() - before)) {
            fail("it became shorter while it was read");
        }
        tag = m_text.find(appendedTag, before < appendedTag.size() ? 0 : before - appendedTag.size());
    }
    if (tag != std::string::npos) {
        findAppended(m_text, tag);
        m_text.resize(tag);
        m_text += "</VTKFile>";
    }
    const pugi::xml_parse_result result = m_document.load_buffer_inplace(m_text.data(), m_text.size());
    if (!result) {
        fail(std::string(result.description()) + " at byte " + std::to_string(result.offset));
    }
}

void XmlArrays::findAppended(const std::string& head, std::size_t tag) {
    std::string start = head.substr(tag, 512);
    if (start.size() < 512 && m_text.size() < m_size) {
        start.resize(512);
        m_file.seekg(static_cast<std::streamoff>(tag));
        m_file.read(start.data(), 512);
        start.resize(static_cast<std::size_t>(m_file.gcount()));
        m_file.clear();
    }
    const std::size_t close = start.find('>');
    const std::size_t mark = close == std::string::npos ? close : start.find('_', close);
    if (mark == std::string::npos) {
        fail("its appended data do not begin");
    }
    m_hasAppended = true;
    m_raw = start.substr(0, close).find("\"raw\"") != std::string::npos;
    m_appended = tag + mark + 1;
    const std::uint64_t tail = std::min<std::uint64_t>(m_size - m_appended, 256);
    std::string end(static_cast<std::size_t>(tail), '\0');
    m_file.seekg(static_cast<std::streamoff>(m_size - tail));
    m_file.read(end.data(), static_cast<std::streamsize>(tail));
    const std::size_t last = end.rfind(appendedClose);
    if (last == std::string::npos || end.find("</VTKFile>", last) == std::string::npos) {
        fail("it ends at byte " + std::to_string(m_size) + " within its appended data");
    }
    m_appendedEnd = m_size - tail + last;
    if (!m_raw) {
        m_encoded.resize(static_cast<std::size_t>(m_appendedEnd - m_appended));
        m_file.seekg(static_cast<std::streamoff>(m_appended));
        m_file.read(m_encoded.data(), static_cast<std::streamsize>(m_encoded.size()));
        m_encoded.resize(trimmed(m_encoded).size());
    }
}

void XmlArrays::readSettings() {
    const pugi::xml_node file = root();
    if (!file) {
        fail("it is no VTK XML");
    }
    m_bigEndian = std::string_view(file.attribute("byte_order").as_string()) == "BigEndian";
    m_header.bytes = std::string_view(file.attribute("header_type").as_string()) == "UInt64" ? 8 : 4;
    const std::string compressor = file.attribute("compressor").as_string();
    if (compressor == "vtkZLibDataCompressor") {
        m_packing = Packing::Zlib;
    } else if (compressor == "vtkLZ4DataCompressor") {
        m_packing = Packing::Lz4;
    } else if (compressor == "vtkLZMADataCompressor") {
        m_packing = Packing::Lzma;
    } else if (!compressor.empty()) {
        fail("it is packed by " + compressor.substr(0, 60) + ", which is not known");
    }
}

NumberType XmlArrays::typeOf(pugi::xml_node array) const {
    using Kind = NumberType::Kind;
    const std::string type = array.attribute("type").as_string();
    constexpr std::array<std::pair<std::string_view, NumberType>, 10> types{{{"Float32", {Kind::Real, 4}},
                                                                             {"Float64", {Kind::Real, 8}},
                                                                             {"Int8", {Kind::Signed, 1}},
                                                                             {"Int16", {Kind::Signed, 2}},
                                                                             {"Int32", {Kind::Signed, 4}},
                                                                             {"Int64", {Kind::Signed, 8}},
                                                                             {"UInt8", {Kind::Unsigned, 1}},
                                                                             {"UInt16", {Kind::Unsigned, 2}},
                                                                             {"UInt32", {Kind::Unsigned, 4}},
                                                                             {"UInt64", {Kind::Unsigned, 8}}}};
    for (const auto& [name, number] : types) {
        if (name == type) {
            return number;
        }
    }
    failArray(array, "is of the type \"" + type.substr(0, 40) + "\", which is no number");
}

template <class T>
std::vector<T> XmlArrays::values(pugi::xml_node array) {
    if (std::string_view(array.attribute("format").as_string("ascii")) == "ascii") {
        std::vector<T> list;
        std::string_view text = array.child_value();
        T value{};
        const auto next = [&] {
            if constexpr (std::is_same_v<T, double>) {
                return takeReal(text, value);
            } else {
                return takeInteger(text, value);
            }
        };
        while (next()) {
            list.push_back(value);
        }
        if (!text.empty()) {
            failArray(array, "holds \"" + std::string(text.substr(0, 20)) + "\" after " + std::to_string(list.size()) + " numbers");
        }
        return list;
    }
    const NumberType type = typeOf(array);
    const std::string bytes = bytesOf(array);
    if (bytes.size() % type.bytes != 0) {
        failArray(array, "takes " + std::to_string(bytes.size()) + " bytes, which is no whole number of values");
    }
    if constexpr (std::is_same_v<T, double>) {
        return realsIn(bytes, type, m_bigEndian);
    } else {
        return integersIn(bytes, type, m_bigEndian);
    }
}

std::vector<double> XmlArrays::reals(pugi::xml_node array) {
    return values<double>(array);
}

std::vector<std::int64_t> XmlArrays::integers(pugi::xml_node array) {
    return values<std::int64_t>(array);
}

// Each text ends with a zero.
std::vector<std::string> XmlArrays::texts(pugi::xml_node array) {
    std::string letters;
    if (std::string_view(array.attribute("format").as_string("ascii")) == "ascii") {
        for (const std::int64_t letter : values<std::int64_t>(array)) {
            letters.push_back(static_cast<char>(letter));
        }
    } else {
        letters = bytesOf(array);
    }
    std::vector<std::string> list;
    for (std::size_t begin = 0; begin < letters.size();) {
        const std::size_t end = std::min(letters.find('\0', begin), letters.size());
        list.push_back(letters.substr(begin, end - begin));
        begin = end + 1;
    }
    return list;
}

XmlArrays::Stream XmlArrays::streamOf(pugi::xml_node array) const {
    const std::string_view format = array.attribute("format").as_string();
    if (format == "binary") {
        const std::string_view text = trimmed(array.child_value());
        return {false, 0, text.size(), text};
    }
    if (format != "appended" || !m_hasAppended) {
        failArray(array, "says no place of its values");
    }
    const std::uint64_t offset = array.attribute("offset").as_ullong();
    const std::uint64_t size = m_raw ? m_appendedEnd - m_appended : m_encoded.size();
    if (offset > size) {
        failArray(array, "begins at " + std::to_string(offset) + " of " + std::to_string(size) + " appended bytes");
    }
    return m_raw ? Stream{true, m_appended + offset, m_appendedEnd, {}} : Stream{false, offset, size, m_encoded};
}

// Takes bytes off a stream; those of base64 in whole groups.
std::string XmlArrays::take(Stream& stream, std::uint64_t count, pugi::xml_node array) {
    const std::uint64_t left = stream.end - stream.at;
    const std::uint64_t needed = stream.raw ? count : base64Length(std::min(count, m_size));
    if (count > m_size || needed > left) {
        failArray(array, "needs " + std::to_string(count) + " bytes where the file has " +
                             std::to_string(stream.raw ? left : left / 4 * 3));
    }
    std::string bytes;
    if (stream.raw) {
        bytes.resize(static_cast<std::size_t>(count));
        m_file.clear();
        m_file.seekg(static_cast<std::streamoff>(stream.at));
        m_file.read(bytes.data(), static_cast<std::streamsize>(count));
        if (m_file.gcount() != static_cast<std::streamsize>(count)) {
            failArray(array, "became shorter while it was read");
        }
    } else if (!decodeBase64(stream.encoded.substr(stream.at, needed), bytes) || bytes.size() < count) {
        failArray(array, "is no base64");
    }
    bytes.resize(static_cast<std::size_t>(count));
    stream.at += needed;
    return bytes;
}

std::string XmlArrays::bytesOf(pugi::xml_node array) {
    Stream stream = streamOf(array);
    if (m_packing != Packing::None) {
        return packedBytes(stream, array);
    }
    Stream whole = stream;
    const auto length = static_cast<std::uint64_t>(integersIn(take(stream, m_header.bytes, array), m_header, m_bigEndian).front());
    if (stream.raw) {
        return take(stream, length, array);
    }
    // The length and the values are one run of base64.
    if (length > m_size) {
        failArray(array, "says that it takes " + std::to_string(length) + " bytes, more than the file");
    }
    return take(whole, m_header.bytes + length, array).substr(m_header.bytes);
}

// A header (number of blocks, size of a block, size of a last one that is smaller, packed size of each), then the blocks.
std::string XmlArrays::packedBytes(Stream& stream, pugi::xml_node array) {
    Stream again = stream;
    const std::vector<std::int64_t> sizes = integersIn(take(again, 3 * m_header.bytes, array), m_header, m_bigEndian);
    const auto blocks = static_cast<std::uint64_t>(sizes[0]), size = static_cast<std::uint64_t>(sizes[1]),
               rest = static_cast<std::uint64_t>(sizes[2]);
    if (blocks > m_size / m_header.bytes || size > m_size * bestLzma || rest > size) {
        failArray(array, "says that it has " + std::to_string(blocks) + " blocks of " + std::to_string(size) + " bytes");
    }
    const std::vector<std::int64_t> header = integersIn(take(stream, (3 + blocks) * m_header.bytes, array), m_header, m_bigEndian);
    std::uint64_t all = 0;
    for (std::uint64_t b = 0; b < blocks; ++b) {
        const auto packed = static_cast<std::uint64_t>(header[3 + b]);
        if (packed > m_size - all) {
            failArray(array, "has blocks that are longer than the file");
        }
        all += packed;
    }
    const std::string stored = take(stream, all, array);
    std::string bytes;
    std::size_t at = 0;
    for (std::uint64_t b = 0; b < blocks; ++b) {
        const auto packed = static_cast<std::size_t>(header[3 + b]);
        bytes += unpacked(stored.substr(at, packed), b + 1 == blocks && rest > 0 ? rest : size, array);
        at += packed;
    }
    return bytes;
}

std::uint64_t XmlArrays::most(std::uint64_t packed) const {
    const std::uint64_t best = m_packing == Packing::Zlib ? bestZlib : m_packing == Packing::Lz4 ? bestLz4 : bestLzma;
    return (packed + 1) * best;
}

std::string XmlArrays::unpacked(const std::string& block, std::uint64_t size, pugi::xml_node array) const {
    if (size > most(block.size()) || size > std::numeric_limits<int>::max()) {
        failArray(array, "says that " + std::to_string(block.size()) + " bytes of it hold " + std::to_string(size));
    }
    std::string bytes(static_cast<std::size_t>(size), '\0');
    bool whole = false;
    if (m_packing == Packing::Zlib) {
        uLongf length = bytes.size();
        whole = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length, reinterpret_cast<const Bytef*>(block.data()),
                           block.size()) == Z_OK &&
                length == bytes.size();
    } else if (m_packing == Packing::Lz4) {
        whole = block.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max()) &&
                LZ4_decompress_safe(block.data(), bytes.data(), static_cast<int>(block.size()), static_cast<int>(size)) ==
                    static_cast<int>(size);
    } else {
        std::uint64_t memory = lzmaMemory;
        std::size_t in = 0, out = 0;
        whole =
            lzma_stream_buffer_decode(&memory, 0, nullptr, reinterpret_cast<const std::uint8_t*>(block.data()), &in, block.size(),
                                      reinterpret_cast<std::uint8_t*>(bytes.data()), &out, bytes.size()) == LZMA_OK &&
            out == bytes.size();
    }
    if (!whole) {
        failArray(array, "holds a block of " + std::to_string(block.size()) + " bytes that cannot be unpacked");
    }
    return bytes;
}

}  // namespace rubble::io
