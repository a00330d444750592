#include "io/exports/gltf/glb_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <stdexcept>

namespace rubble::io {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

namespace {

// Numbers of the format (glTF 2.0, sections 4 and 5.1).
constexpr std::uint32_t magic = 0x46546C67;
constexpr std::uint32_t version = 2;
constexpr std::uint32_t jsonChunk = 0x4E4F534A;
constexpr std::uint32_t binaryChunk = 0x004E4942;
constexpr int unsignedInteger = 5125;
constexpr int singleFloat = 5126;
constexpr int arrayBuffer = 34962;
constexpr int elementArrayBuffer = 34963;

std::uint64_t alignedTo4(std::uint64_t size) {
    return (size + 3) / 4 * 4;
}

void put(std::ostream& out, std::uint32_t number) {
    out.write(reinterpret_cast<const char*>(&number), sizeof number);
}

}  // namespace

GlbFile::GlbFile() : m_asset(nlohmann::json::object()) {}

std::size_t GlbFile::add(View view, const void* data, std::size_t bytes, nlohmann::json accessor) {
    std::vector<char>& to = m_bytes[view];
    accessor["bufferView"] = static_cast<int>(view);
    accessor["byteOffset"] = to.size();
    const auto* from = static_cast<const char*>(data);
    to.insert(to.end(), from, from + bytes);
    m_accessors.push_back(std::move(accessor));
    return m_accessors.size() - 1;
}

std::size_t GlbFile::addPositions(std::span<const float> xyz) {
    std::array<float, 3> least{xyz[0], xyz[1], xyz[2]};
    std::array<float, 3> most = least;
    for (std::size_t i = 0; i < xyz.size(); ++i) {
        least[i % 3] = std::min(least[i % 3], xyz[i]);
        most[i % 3] = std::max(most[i % 3], xyz[i]);
    }
    return add(Vertices, xyz.data(), xyz.size_bytes(),
               {{"componentType", singleFloat}, {"type", "VEC3"}, {"count", xyz.size() / 3}, {"min", least}, {"max", most}});
}

std::size_t GlbFile::addTriangles(std::span<const std::uint32_t> corners) {
    return add(Indices, corners.data(), corners.size_bytes(),
               {{"componentType", unsignedInteger}, {"type", "SCALAR"}, {"count", corners.size()}});
}

std::size_t GlbFile::addTimes(std::span<const float> times) {
    return add(Animation, times.data(), times.size_bytes(),
               {{"componentType", singleFloat},
                {"type", "SCALAR"},
                {"count", times.size()},
                {"min", nlohmann::json::array({times.front()})},
                {"max", nlohmann::json::array({times.back()})}});
}

std::size_t GlbFile::addValues(std::span<const float> values, std::size_t width) {
    return add(Animation, values.data(), values.size_bytes(),
               {{"componentType", singleFloat}, {"type", width == 3 ? "VEC3" : "VEC4"}, {"count", values.size() / width}});
}

std::uint64_t GlbFile::binaryBytes() const {
    std::uint64_t bytes = 0;
    for (const std::vector<char>& part : m_bytes) {
        bytes += part.size();
    }
    return bytes;
}

void GlbFile::write(std::ostream& out) const {
    nlohmann::json whole = m_asset;
    whole["accessors"] = m_accessors;
    whole["buffers"] = nlohmann::json::array({{{"byteLength", binaryBytes()}}});
    whole["bufferViews"] = nlohmann::json::array();
    std::uint64_t offset = 0;
    for (std::size_t v = 0; v < viewCount; ++v) {
        nlohmann::json view{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", m_bytes[v].size()}};
        if (v == Vertices) {
            view["target"] = arrayBuffer;
            view["byteStride"] = 3 * sizeof(float);
        } else if (v == Indices) {
            view["target"] = elementArrayBuffer;
        }
        whole["bufferViews"].push_back(std::move(view));
        offset += m_bytes[v].size();
    }
    std::string text = whole.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    text.resize(alignedTo4(text.size()), ' ');
    const std::uint64_t binary = alignedTo4(binaryBytes());
    const std::uint64_t all = 12 + 8 + text.size() + 8 + binary;
    if (all > std::numeric_limits<std::uint32_t>::max()) {
        throw std::length_error("larger than a GLB file can be");
    }
    put(out, magic);
    put(out, version);
    put(out, static_cast<std::uint32_t>(all));
    put(out, static_cast<std::uint32_t>(text.size()));
    put(out, jsonChunk);
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    put(out, static_cast<std::uint32_t>(binary));
    put(out, binaryChunk);
    for (const std::vector<char>& part : m_bytes) {
        out.write(part.data(), static_cast<std::streamsize>(part.size()));
    }
    out.write("\0\0\0", static_cast<std::streamsize>(binary - binaryBytes()));
}

}  // namespace rubble::io
