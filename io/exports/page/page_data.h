#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "core/base/execution.h"
#include "core/base/geometry.h"

namespace rubble::io {

/// Integers in as few bytes as each needs: seven bits a byte, the least first; the sign is the lowest bit.
class PackedIntegers {
public:
    void add(std::int64_t number);
    /// Each as its difference to the one before; the first as it is.
    void addSteps(std::span<const std::int64_t> numbers);
    /// Of zeros in a row the first, and then how many more follow.
    void addRuns(std::span<const std::int64_t> numbers);

    std::size_t count() const { return m_count; }
    const std::string& bytes() const { return m_bytes; }

private:
    std::string m_bytes;
    std::size_t m_count = 0;
};

/// Places in steps, each as its difference to the one before; those that follow one another lie close together.
class PackedPlaces {
public:
    /// @param step  m
    explicit PackedPlaces(double step) : m_step(step) {}
    /// m
    void add(const Vec3& place);

    const PackedIntegers& numbers() const { return m_numbers; }
    /// m, largest distance of a place from where its steps have it.
    double largestError() const { return m_largestError; }

private:
    double m_step;
    std::array<std::int64_t, 3> m_before{};
    PackedIntegers m_numbers;
    double m_largestError = 0.0;
};

/// The numbers of a page: named arrays one behind the other, each at a multiple of eight bytes, and compressed as a whole. The
/// script of the page (resources/page/10-numbers.js) unpacks them.
class PageData {
public:
    void add(std::string_view name, std::span<const double> numbers);
    void add(std::string_view name, std::span<const float> numbers);
    void add(std::string_view name, std::span<const std::uint8_t> numbers);
    void add(std::string_view name, const PackedIntegers& numbers);

    /// {name: {type, at, bytes, count}}; type is f64, f32, u8 or packed.
    const nlohmann::json& contents() const { return m_contents; }
    /// Bytes before compression.
    std::size_t size() const { return m_bytes.size(); }
    /// In the zlib format (RFC 1950). Throws Cancelled.
    std::string compressed(const Execution& execution) const;

private:
    void add(std::string_view name, std::string_view type, const void* data, std::size_t bytes, std::size_t count);

    std::string m_bytes;
    nlohmann::json m_contents = nlohmann::json::object();
};

}  // namespace rubble::io
