#include "io/site/clouds/las/laz_unpacker.h"

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

std::optional<std::vector<unsigned char>> LazUnpacker::unpack(LazChunk chunk) {
    std::vector<unsigned char> records(static_cast<std::size_t>(chunk.points) * m_head.recordBytes);
    if (!start(chunk, true, records.data())) {
        return std::nullopt;
    }
    for (std::size_t at = m_head.recordBytes; at < records.size(); at += m_head.recordBytes) {
        decode(&records[at]);
    }
    return overrun() ? std::nullopt : std::optional(std::move(records));
}

}  // namespace rubble::io
