#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace rubble {

/// 128-bit content hash (XXH3): names results and trajectories. Not a cryptographic digest; files carry SHA-256 (io).
struct Digest {
    std::array<std::uint8_t, 16> bytes{};

    std::string hex() const;
    friend bool operator==(const Digest&, const Digest&) = default;
    friend auto operator<=>(const Digest&, const Digest&) = default;
};

/// Accumulates a Digest. Strings and spans are fed with their length, so that neighbours cannot run into each other.
class Hasher {
public:
    Hasher();
    ~Hasher();
    Hasher(Hasher&&) noexcept;
    Hasher& operator=(Hasher&&) noexcept;

    Hasher& bytes(const void* data, std::size_t size);
    Hasher& text(std::string_view text);
    template <class T>
        requires(std::is_arithmetic_v<T> || std::is_enum_v<T>)
    Hasher& value(T value) {
        return bytes(&value, sizeof value);
    }
    template <class T>
        requires(std::is_trivially_copyable_v<T>)
    Hasher& values(std::span<const T> values) {
        value(static_cast<std::uint64_t>(values.size()));
        return bytes(values.data(), values.size_bytes());
    }
    Hasher& digest(const Digest& digest) { return bytes(digest.bytes.data(), digest.bytes.size()); }

    /// The digest of all fed so far; feeding may go on.
    Digest finish() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace rubble
