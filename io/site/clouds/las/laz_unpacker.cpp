#include "io/site/clouds/las/laz_unpacker.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace rubble::io {

bool LazUnpacker::start(LazChunk& chunk, bool counted, unsigned char* record) {
    if (m_layered) {
        if (!m_layers.start(m_file, chunk.start, record)) {
            return false;
        }
        chunk.points = counted ? chunk.points : m_layers.points();
        return chunk.points == 1 || (chunk.points > 1 && m_layers.holdsMore());
    }
    m_bytes.emplace(m_file, chunk.start, chunk.end);
    m_bytes->take(record, m_head.recordBytes);
    m_points.start(record);
    m_decoder.emplace(*m_bytes);
    // A point alone is followed by no packed bytes.
    if (chunk.points > 1) {
        m_decoder->start();
    }
    return chunk.points > 0;
}

std::vector<unsigned char> LazUnpacker::roomFor(const LazChunk& chunk) {
    m_room.resize(static_cast<std::size_t>(chunk.points) * m_head.recordBytes);
    return std::exchange(m_room, {});
}

LazRecords LazUnpacker::unpack(LazChunk chunk) {
    std::vector<unsigned char> records = roomFor(chunk);
    if (!start(chunk, true, records.data())) {
        return std::nullopt;
    }
    for (std::size_t at = m_head.recordBytes; at < records.size(); at += m_head.recordBytes) {
        decode(&records[at]);
    }
    return overrun() ? std::nullopt : LazRecords(std::move(records));
}

std::vector<LazRecords> LazUnpacker::unpackTogether(std::span<const std::unique_ptr<LazUnpacker>> unpackers,
                                                    std::span<const LazChunk> chunks) {
    std::vector<LazRecords> records(chunks.size());
    // Layers are decoded beside each other as they are.
    if (chunks.size() < lanes || unpackers[0]->m_layered) {
        for (std::size_t k = 0; k < chunks.size(); ++k) {
            records[k] = unpackers[k]->unpack(chunks[k]);
        }
        return records;
    }
    const std::size_t bytes = unpackers[0]->m_head.recordBytes;
    std::array<LazPoints*, lanes> points{};
    std::array<ArithmeticDecoder*, lanes> decoders{};
    std::array<unsigned char*, lanes> at{};
    std::size_t common = std::numeric_limits<std::size_t>::max();
    for (std::size_t k = 0; k < lanes; ++k) {
        records[k] = unpackers[k]->roomFor(chunks[k]);
        at[k] = records[k]->data();
        LazChunk chunk = chunks[k];
        unpackers[k]->start(chunk, true, at[k]);
        points[k] = &unpackers[k]->m_points;
        decoders[k] = &*unpackers[k]->m_decoder;
        common = std::min(common, records[k]->size());
    }
    for (std::size_t done = bytes; done < common; done += bytes) {
        for (unsigned char*& record : at) {
            record += bytes;
        }
        LazPoints::decodeTogether(points, decoders, at);
    }
    for (std::size_t k = 0; k < lanes; ++k) {
        for (std::size_t rest = common; rest < records[k]->size(); rest += bytes) {
            unpackers[k]->decode(records[k]->data() + rest);
        }
        if (unpackers[k]->overrun()) {
            records[k].reset();
        }
    }
    return records;
}

}  // namespace rubble::io
