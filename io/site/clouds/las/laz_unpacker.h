#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "io/site/clouds/las/laz_chunks.h"
#include "io/site/clouds/las/laz_points.h"

namespace rubble::io {

/// Records of the points of a chunk; nothing: it is damaged.
using LazRecords = std::optional<std::vector<unsigned char>>;

/// Unpacks the points of one chunk after another, whichever way they are packed.
class LazUnpacker {
public:
    /// @param file, head  must outlive this object
    LazUnpacker(const CloudFile& file, const LasHead& head, const LazPacking& packing)
        : m_file(file), m_head(head), m_layered(packing.layered), m_points(head), m_layers(head, packing.turns) {}

    /// Begins a chunk.
    /// @param record  gets its first point
    /// @param counted  a table says how many points it has; else it is asked, where it knows
    /// @return false: it cannot be
    bool start(LazChunk& chunk, bool counted, unsigned char* record);
    /// Writes the record of the next point, if there is one.
    void decode(unsigned char* record) { m_layered ? m_layers.decode(record) : m_points.decode(*m_decoder, record); }
    /// The bytes ended before the points did: some of the last ones are none.
    bool overrun() const { return m_layered ? m_layers.overrun() : m_bytes && m_bytes->overrun(); }
    /// Behind the chunk, once all its points are unpacked.
    std::uint64_t end() const { return m_layered ? m_layers.end() : m_bytes->position(); }

    /// Gives room for the records of a later chunk, which saves asking for new memory.
    void reuse(std::vector<unsigned char> room) { m_room = std::move(room); }
    /// All records of a chunk that a table names.
    LazRecords unpack(LazChunk chunk);
    /// Chunks that are unpacked at once in the least time.
    static constexpr std::size_t lanes = LazPoints::lanes;
    /// The same of so many chunks or fewer, by an unpacker each, in less time than one after another.
    static std::vector<LazRecords> unpackTogether(std::span<const std::unique_ptr<LazUnpacker>> unpackers,
                                                  std::span<const LazChunk> chunks);

private:
    const CloudFile& m_file;
    const LasHead& m_head;
    bool m_layered;
    LazPoints m_points;
    LazLayers m_layers;
    struct Lane;
    std::vector<unsigned char> roomFor(const LazChunk& chunk);
    /// Goes on with all lanes until the last one, which has the fewest records left, ends.
    template <std::size_t Count>
    static void unpackLanes(std::span<Lane> open, std::size_t recordBytes);

    std::vector<unsigned char> m_room;
    std::optional<PackedBytes> m_bytes;
    std::optional<ArithmeticDecoder> m_decoder;
};

}  // namespace rubble::io
