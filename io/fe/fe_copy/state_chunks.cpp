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

#include "core/base/error.h"

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
std::vector<Vec3> unshuffled(const std::vector<unsigned char>& bytes) {
    static_assert(sizeof(Number) == sizeof(Bits) && sizeof(Vec3) == 3 * sizeof(double));
    constexpr std::size_t block = 512;  // numbers that are put together at once, byte by byte, so that the compiler does several
    const std::size_t count = bytes.size() / sizeof(Number);
    std::vector<Vec3> vectors(count / 3);
    for (std::size_t first = 0; first < 3 * vectors.size(); first += block) {
        const std::size_t length = std::min(block, 3 * vectors.size() - first);
        std::array<Bits, block> bits{};
        for (std::size_t b = 0; b < sizeof(Bits); ++b) {
            const unsigned char* plane = bytes.data() + b * count + first;
            for (std::size_t i = 0; i < length; ++i) {
                bits[i] |= static_cast<Bits>(plane[i]) << (8 * b);
            }
        }
        double* numbers = vectors.front().data() + first;
        for (std::size_t i = 0; i < length; ++i) {
            numbers[i] = static_cast<double>(std::bit_cast<Number>(bits[i]));
        }
    }
    return vectors;
}

}  // namespace

StateChunks::StateChunks(const std::string& path) : m_file(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (m_file < 0) {
        throw WorldError({"io.file.unreadable", "Cannot read {0}", {path}},
                         {"io.file.unreadable.remedy", "Check that the file exists and that you may read it.", {}});
    }
}

StateChunks::~StateChunks() {
    ::close(m_file);
}

std::optional<std::vector<Vec3>> StateChunks::read(const ChunkPlace& place, std::size_t count) const {
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
    const std::size_t single = 3 * sizeof(float) * count, full = 3 * sizeof(double) * count;
    std::optional<std::vector<unsigned char>> bytes;
    if (place.filtersLeftOut == 0) {
        bytes = inflated(stored, full);
    } else if (place.filtersLeftOut == deflateLeftOut) {
        bytes = std::move(stored);
    }
    if (!bytes || (bytes->size() != single && bytes->size() != full)) {
        return std::nullopt;
    }
    return bytes->size() == single ? unshuffled<float, std::uint32_t>(*bytes) : unshuffled<double, std::uint64_t>(*bytes);
}

}  // namespace rubble::io
