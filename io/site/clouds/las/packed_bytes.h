#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "io/site/clouds/cloud_file.h"

namespace rubble::io {

/// Bytes of a file one after another, a window of it in memory. Behind their end come zeros, which are counted.
class PackedBytes {
public:
    /// Between two places of a file, which must outlive this object.
    PackedBytes(const CloudFile& file, std::uint64_t start, std::uint64_t end) : m_file(&file), m_from(start), m_end(end) {}

    unsigned char next() {
        if (m_at == m_filled) [[unlikely]] {
            refill();
        }
        return *m_at++;
    }
    /// Four bytes can be looked at without a refill.
    bool holdsFour() const { return m_filled - m_at >= 4; }
    /// The next four as a number, big end first, without taking them.
    std::uint32_t ahead() const { return __builtin_bswap32(littleAt<std::uint32_t>(m_at)); }
    /// Passes over bytes that were looked at.
    void skip(std::uint32_t count) { m_at += count; }
    /// The next ones, as next() gives them.
    void take(unsigned char* target, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            target[i] = next();
        }
    }
    std::uint32_t takeWhole() {
        std::array<unsigned char, 4> bytes{};
        take(bytes.data(), bytes.size());
        return littleAt<std::uint32_t>(bytes.data());
    }
    /// Of the next byte in the file.
    std::uint64_t position() const { return m_from - static_cast<std::uint64_t>(m_filled - m_at); }
    /// More was asked for than there is.
    bool overrun() const { return m_beyond > 0; }

private:
    void refill();

    const CloudFile* m_file;
    std::uint64_t m_from;  ///< of what comes behind the window
    std::uint64_t m_end;
    std::vector<unsigned char> m_window;
    const unsigned char* m_at = nullptr;
    const unsigned char* m_filled = nullptr;
    std::uint64_t m_beyond = 0;
};

}  // namespace rubble::io
