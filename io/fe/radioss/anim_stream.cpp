#include "io/fe/radioss/anim_stream.h"

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <limits>

#include "core/base/error.h"
#include "io/base/files.h"

namespace rubble::io {

namespace {

// Nothing packs better than this by gzip.
constexpr std::int64_t bestPacking = 1032;
constexpr std::size_t chunk = std::size_t{1} << 18;

std::uint32_t wordOf(const unsigned char* b) {
    return static_cast<std::uint32_t>(b[0]) << 24 | static_cast<std::uint32_t>(b[1]) << 16 | static_cast<std::uint32_t>(b[2]) << 8 |
           b[3];
}

}  // namespace

AnimStream::AnimStream(const std::string& path) : m_path(path), m_file(gzopen(path.c_str(), "rb"), &gzclose) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!m_file || error) {
        failToRead(path);
    }
    gzbuffer(m_file.get(), static_cast<unsigned>(std::clamp<std::uintmax_t>(size, 1u << 12, 1u << 17)));
    m_most = static_cast<std::int64_t>(size) * (gzdirect(m_file.get()) != 0 ? 1 : bestPacking);
}

void AnimStream::failCut(std::int64_t needed, const char* what) const {
    throw ParseError({"anim.cut",
                      "{0} is cut off: {1} take {2} bytes from byte {3} on, which the file does not have",
                      {m_path, what, needed, m_place}},
                     {"anim.cut.remedy", "Copy the file again, or wait until the analysis has written it.", {}});
}

void AnimStream::require(std::size_t bytes, const char* what) const {
    if (static_cast<std::int64_t>(std::min<std::size_t>(bytes, std::size_t{1} << 62)) > m_most - m_place) {
        failCut(static_cast<std::int64_t>(std::min<std::size_t>(bytes, std::size_t{1} << 62)), what);
    }
}

void AnimStream::take(unsigned char* to, std::size_t bytes, const char* what) {
    for (std::size_t done = 0; done < bytes;) {
        const auto part = static_cast<unsigned>(std::min(bytes - done, chunk));
        const int got = gzread(m_file.get(), to + done, part);
        if (got <= 0) {
            failCut(static_cast<std::int64_t>(bytes), what);
        }
        done += static_cast<std::size_t>(got);
    }
    m_place += static_cast<std::int64_t>(bytes);
}

std::int64_t AnimStream::integer(const char* what) {
    return integers(1, what).front();
}

double AnimStream::real(const char* what) {
    return reals(1, what).front();
}

std::vector<std::int64_t> AnimStream::integers(std::size_t count, const char* what) {
    require(4 * count, what);
    std::vector<std::int64_t> values;
    std::vector<unsigned char> buffer;
    while (values.size() < count) {
        const std::size_t part = std::min(count - values.size(), chunk / 4);
        buffer.resize(4 * part);
        take(buffer.data(), buffer.size(), what);
        for (std::size_t i = 0; i < part; ++i) {
            values.push_back(static_cast<std::int32_t>(wordOf(buffer.data() + 4 * i)));
        }
    }
    return values;
}

std::vector<double> AnimStream::reals(std::size_t count, const char* what) {
    require(4 * count, what);
    std::vector<double> values;
    std::vector<unsigned char> buffer;
    while (values.size() < count) {
        const std::size_t part = std::min(count - values.size(), chunk / 4);
        buffer.resize(4 * part);
        take(buffer.data(), buffer.size(), what);
        for (std::size_t i = 0; i < part; ++i) {
            values.push_back(static_cast<double>(std::bit_cast<float>(wordOf(buffer.data() + 4 * i))));
        }
    }
    return values;
}

std::vector<std::uint8_t> AnimStream::bytes(std::size_t count, const char* what) {
    require(count, what);
    std::vector<std::uint8_t> values;
    while (values.size() < count) {
        const std::size_t before = values.size();
        values.resize(before + std::min(count - before, chunk));
        take(values.data() + before, values.size() - before, what);
    }
    return values;
}

std::string AnimStream::text(std::size_t length, const char* what) {
    const std::vector<std::uint8_t> raw = bytes(length, what);
    const std::string whole(raw.begin(), raw.end());
    return whole.substr(0, whole.find('\0'));
}

void AnimStream::skip(std::initializer_list<std::size_t> factors, const char* what) {
    std::size_t bytes = 1;
    for (const std::size_t factor : factors) {
        if (__builtin_mul_overflow(bytes, factor, &bytes)) {
            bytes = factor == 0 ? 0 : std::numeric_limits<std::size_t>::max();
        }
    }
    if (bytes == 0) {
        return;
    }
    require(bytes, what);
    // The last byte is read: seeking beyond the end of a packed file is no error.
    if (bytes > 1 && gzseek(m_file.get(), static_cast<z_off_t>(bytes - 1), SEEK_CUR) < 0) {
        failCut(static_cast<std::int64_t>(bytes), what);
    }
    m_place += static_cast<std::int64_t>(bytes - 1);
    unsigned char last = 0;
    take(&last, 1, what);
}

}  // namespace rubble::io
