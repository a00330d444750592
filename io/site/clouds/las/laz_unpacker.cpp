#include "io/site/clouds/las/laz_unpacker.h"

#include <algorithm>

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

LazRecords LazUnpacker::unpack(LazChunk chunk) {
    std::vector<unsigned char> records(static_cast<std::size_t>(chunk.points) * m_head.recordBytes);
    if (!start(chunk, true, records.data())) {
        return std::nullopt;
    }
    for (std::size_t at = m_head.recordBytes; at < records.size(); at += m_head.recordBytes) {
        decode(&records[at]);
    }
    return overrun() ? std::nullopt : LazRecords(std::move(records));
}

std::array<LazRecords, 2> LazUnpacker::unpackBoth(std::array<LazUnpacker*, 2> unpackers, std::array<LazChunk, 2> chunks) {
    LazUnpacker& one = *unpackers[0];
    LazUnpacker& other = *unpackers[1];
    // Layers are decoded beside each other as they are.
    if (one.m_layered) {
        return {one.unpack(chunks[0]), other.unpack(chunks[1])};
    }
    const std::size_t bytes = one.m_head.recordBytes;
    std::array<LazRecords, 2> records;
    for (std::size_t k = 0; k < 2; ++k) {
        records[k].emplace(static_cast<std::size_t>(chunks[k].points) * bytes);
        if (!unpackers[k]->start(chunks[k], true, records[k]->data())) {
            records[k].reset();
        }
    }
    const std::size_t common = records[0] && records[1] ? std::min(records[0]->size(), records[1]->size()) : 0;
    std::size_t at = bytes;
    for (; at < common; at += bytes) {
        LazPoints::decodeBoth({&one.m_points, &other.m_points}, {&*one.m_decoder, &*other.m_decoder},
                              {records[0]->data() + at, records[1]->data() + at});
    }
    for (std::size_t k = 0; k < 2; ++k) {
        for (std::size_t rest = at; records[k] && rest < records[k]->size(); rest += bytes) {
            unpackers[k]->decode(records[k]->data() + rest);
        }
        if (unpackers[k]->overrun()) {
            records[k].reset();
        }
    }
    return records;
}

}  // namespace rubble::io
