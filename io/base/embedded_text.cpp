#include "io/base/embedded_text.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <vector>

#include "io/base/files.h"

namespace rubble::io {

namespace {

constexpr std::array<unsigned char, 8> pngSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
// A provenance is some ten thousand characters; what says it is longer is damaged.
constexpr std::size_t textMax = std::size_t{8} << 20;

std::uint32_t bigEndian(const unsigned char* at) {
    return static_cast<std::uint32_t>(at[0]) << 24 | static_cast<std::uint32_t>(at[1]) << 16 |
           static_cast<std::uint32_t>(at[2]) << 8 | at[3];
}

/// Inflates what zlib packed; empty if it is damaged or too long.
std::string inflated(std::string_view packed) {
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) {
        return {};
    }
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    std::string text;
    std::array<char, 1 << 14> block{};
    int state = Z_OK;
    while (state == Z_OK && text.size() < textMax) {
        stream.next_out = reinterpret_cast<Bytef*>(block.data());
        stream.avail_out = block.size();
        state = inflate(&stream, Z_NO_FLUSH);
        text.append(block.data(), block.size() - stream.avail_out);
    }
    inflateEnd(&stream);
    return state == Z_STREAM_END ? text : std::string();
}

/// The text of a chunk with our keyword (PNG specification, 11.3.3); empty for others.
std::string chunkText(std::string_view type, std::string_view chunk) {
    const std::size_t end = chunk.find('\0');
    if (end == std::string_view::npos || chunk.substr(0, end) != provenanceKeyword) {
        return {};
    }
    std::string_view rest = chunk.substr(end + 1);
    if (type == "tEXt") {
        return std::string(rest);
    }
    if (type == "zTXt") {
        return rest.empty() ? std::string() : inflated(rest.substr(1));
    }
    // iTXt: compression flag and method, then language and translated keyword, each ended by a zero.
    if (rest.size() < 2) {
        return {};
    }
    const bool packed = rest[0] != 0;
    rest.remove_prefix(2);
    for (int skipped = 0; skipped < 2; ++skipped) {
        const std::size_t zero = rest.find('\0');
        if (zero == std::string_view::npos) {
            return {};
        }
        rest.remove_prefix(zero + 1);
    }
    return packed ? inflated(rest) : std::string(rest);
}

std::string textOfPng(std::istream& in) {
    std::array<unsigned char, 8> head{};
    std::string chunk;
    while (in.read(reinterpret_cast<char*>(head.data()), head.size())) {
        const std::uint32_t length = bigEndian(head.data());
        const std::string type(reinterpret_cast<const char*>(head.data()) + 4, 4);
        if (type == "IEND") {
            break;
        }
        if ((type != "tEXt" && type != "zTXt" && type != "iTXt") || length > textMax) {
            in.seekg(static_cast<std::streamoff>(length) + 4, std::ios::cur);
            continue;
        }
        chunk.resize(length);
        if (!in.read(chunk.data(), static_cast<std::streamsize>(length))) {
            break;
        }
        in.seekg(4, std::ios::cur);
        if (const std::string text = chunkText(type, chunk); !text.empty()) {
            return text;
        }
    }
    return {};
}

/// The whole JSON object that a text begins with; empty if it does not end.
std::string wholeObject(std::string_view text) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted) {
            i += c == '\\' ? 1 : 0;
            quoted = c != '"';
        } else if (c == '"') {
            quoted = true;
        } else if (c == '{') {
            ++depth;
        } else if (c == '}' && --depth == 0) {
            return std::string(text.substr(0, i + 1));
        }
    }
    return {};
}

/// Looks through a file block by block for where the object begins, and reads on from there.
std::string textInside(std::istream& in) {
    const std::string_view start = provenanceStart;
    std::string window;
    std::vector<char> block(std::size_t{1} << 16);
    while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
        window.append(block.data(), static_cast<std::size_t>(in.gcount()));
        if (const std::size_t found = window.find(start); found != std::string::npos) {
            window.erase(0, found);
            while (window.size() < textMax &&
                   (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0)) {
                window.append(block.data(), static_cast<std::size_t>(in.gcount()));
            }
            return wholeObject(window);
        }
        window.erase(0, window.size() - std::min(window.size(), start.size() - 1));
    }
    return {};
}

}  // namespace

std::string embeddedProvenance(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::array<char, 8> head{};
    if (!in.is_open() || (!in.read(head.data(), head.size()) && in.bad())) {
        failToRead(path);
    }
    const bool png = in.gcount() == 8 && std::equal(pngSignature.begin(), pngSignature.end(), head.begin(),
                                                    [](unsigned char a, char b) { return a == static_cast<unsigned char>(b); });
    if (png) {
        return textOfPng(in);
    }
    in.clear();
    in.seekg(0);
    return textInside(in);
}

}  // namespace rubble::io
