#include "io/fe/fe_copy/state_chunks.h"

#include <fcntl.h>
#include <libdeflate.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>

#include "io/base/files.h"

namespace rubble::io {

namespace {

static_assert(std::endian::native == std::endian::little, "chunks are little-endian");

constexpr std::int64_t deflateLeftOut = 2;  // the second filter

struct Decompressor {
    libdeflate_decompressor* own = libdeflate_alloc_decompressor();
    Decompressor() = default;
    ~Decompressor() { libdeflate_free_decompressor(own); }
    Decompressor(const Decompressor&) = delete;
    Decompressor& operator=(const Decompressor&) = delete;
};

// By libdeflate, which takes half of zlib's time for bytes in planes.
std::optional<std::vector<unsigned char>> inflated(const std::vector<unsigned char>& stored, std::size_t most) {
    std::vector<unsigned char> bytes(most);
    std::size_t length = 0;
    const Decompressor decompressor;
    if (!decompressor.own || libdeflate_zlib_decompress(decompressor.own, stored.data(), stored.size(), bytes.data(), most,
                                                        &length) != LIBDEFLATE_SUCCESS) {
        return std::nullopt;
    }
    bytes.resize(length);
    return bytes;
}

// First all first bytes of the numbers, then all second ones, and so on.
template <class Number, class Bits>
void unshuffle(const std::vector<unsigned char>& bytes, double* numbers) {
    static_assert(sizeof(Number) == sizeof(Bits));
    constexpr std::size_t block = 512;  // numbers that are put together at once, byte by byte, so that the compiler does several
    const std::size_t count = bytes.size() / sizeof(Number);
    for (std::size_t first = 0; first < count; first += block) {
        const std::size_t length = std::min(block, count - first);
        std::array<Bits, block> bits{};
        for (std::size_t b = 0; b < sizeof(Bits); ++b) {
            const unsigned char* plane = bytes.data() + b * count + first;
            for (std::size_t i = 0; i < length; ++i) {
                bits[i] |= static_cast<Bits>(plane[i]) << (8 * b);
            }
        }
        for (std::size_t i = 0; i < length; ++i) {
            numbers[first + i] = static_cast<double>(std::bit_cast<Number>(bits[i]));
        }
    }
}

template <class Number>
void unpack(const std::vector<unsigned char>& bytes, double* numbers) {
    for (std::size_t i = 0; i < bytes.size() / sizeof(Number); ++i) {
        Number number;
        std::memcpy(&number, bytes.data() + i * sizeof(Number), sizeof(Number));
        numbers[i] = static_cast<double>(number);
    }
}

void unpack(const std::vector<unsigned char>& bytes, std::span<double> numbers, bool shuffled) {
    const bool single = bytes.size() == sizeof(float) * numbers.size();
    if (shuffled) {
        single ? unshuffle<float, std::uint32_t>(bytes, numbers.data()) : unshuffle<double, std::uint64_t>(bytes, numbers.data());
    } else {
        single ? unpack<float>(bytes, numbers.data()) : unpack<double>(bytes, numbers.data());
    }
}

}  // namespace

StateChunks::StateChunks(const std::string& path) : m_file(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (m_file < 0) {
        failToRead(path, errno);
    }
}

StateChunks::~StateChunks() {
    ::close(m_file);
}

/// Unpacked, but still shuffled.
std::optional<std::vector<unsigned char>> StateChunks::bytesOf(const ChunkPlace& place, std::size_t numbers) const {
    struct stat status{};
    if (::fstat(m_file, &status) != 0 || place.address < 0 || place.bytes <= 0 || place.bytes > status.st_size ||
        place.address > status.st_size - place.bytes) {
        return std::nullopt;
    }
    std::vector<unsigned char> stored(static_cast<std::size_t>(place.bytes));
    for (std::size_t done = 0; done < stored.size();) {
        const ssize_t got = ::pread(m_file, stored.data() + done, stored.size() - done, place.address + static_cast<off_t>(done));
        if (got == 0 || (got < 0 && errno != EINTR)) {
            return std::nullopt;
        }
        done += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
    }
    const std::size_t single = sizeof(float) * numbers, full = sizeof(double) * numbers;
    std::optional<std::vector<unsigned char>> bytes;
    if (place.filtersLeftOut == 0) {
        bytes = inflated(stored, full);
    } else if (place.filtersLeftOut == deflateLeftOut) {
        bytes = std::move(stored);
    }
    return bytes && (bytes->size() == single || bytes->size() == full) ? std::move(bytes) : std::nullopt;
}

std::optional<std::vector<Vec3>> StateChunks::read(const ChunkPlace& place, std::size_t count) const {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    const auto bytes = bytesOf(place, 3 * count);
    if (!bytes) {
        return std::nullopt;
    }
    std::vector<Vec3> vectors(count);
    if (count > 0) {
        unpack(*bytes, std::span(vectors.front().data(), 3 * count), true);
    }
    return vectors;
}

bool StateChunks::read(const ChunkPlace& place, std::span<double> numbers, bool shuffled) const {
    const auto bytes = bytesOf(place, numbers.size());
    if (bytes) {
        unpack(*bytes, numbers, shuffled);
    }
    return bytes.has_value();
}

}  // namespace rubble::io
