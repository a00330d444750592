#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace rubble::io {

/// A glTF 2.0 asset in one binary file (.glb): collects arrays in three buffer views (vertices, indices, animation) and numbers
/// their accessors. Everything is little-endian and lies at multiples of four bytes.
class GlbFile {
public:
    GlbFile();

    /// Each adds an accessor and returns its index. Arrays must not be empty.
    std::size_t addPositions(std::span<const float> xyz);
    std::size_t addTriangles(std::span<const std::uint32_t> corners);
    /// Times of an animation, s, ascending.
    std::size_t addTimes(std::span<const float> times);
    /// Values of an animation. @param width  3 or 4 numbers each
    std::size_t addValues(std::span<const float> values, std::size_t width);

    /// The asset without buffers, views and accessors, which write() adds.
    nlohmann::json& asset() { return m_asset; }
    /// Bytes that the file will have, but for its JSON.
    std::uint64_t binaryBytes() const;
    /// Throws std::length_error if the file would not fit the format's 32-bit lengths.
    void write(std::ostream& out) const;

private:
    enum View { Vertices, Indices, Animation };
    static constexpr std::size_t viewCount = 3;

    std::size_t add(View view, const void* data, std::size_t bytes, nlohmann::json accessor);

    nlohmann::json m_asset;
    nlohmann::json m_accessors = nlohmann::json::array();
    std::array<std::vector<char>, viewCount> m_bytes;
};

}  // namespace rubble::io
