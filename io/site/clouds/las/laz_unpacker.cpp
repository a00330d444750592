#include "io/site/clouds/las/laz_unpacker.h"

#include <algorithm>
#include <array>
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

/// A chunk that is unpacked beside others.
struct LazUnpacker::Lane {
    LazPoints* points = nullptr;
    ArithmeticDecoder* decoder = nullptr;
    unsigned char* at = nullptr;  ///< the record that was written last
    std::size_t left = 0;         ///< records
};

template <std::size_t Count>
void LazUnpacker::unpackLanes(std::span<Lane> open, std::size_t recordBytes) {
    std::array<LazPoints*, Count> points{};
    std::array<ArithmeticDecoder*, Count> decoders{};
    std::array<unsigned char*, Count> at{};
    for (std::size_t k = 0; k < Count; ++k) {
        points[k] = open[k].points;
        decoders[k] = open[k].decoder;
        at[k] = open[k].at;
    }
    const std::size_t common = open.back().left;
    for (std::size_t done = 0; done < common; ++done) {
        for (unsigned char*& record : at) {
            record += recordBytes;
        }
        LazPoints::decodeTogether<Count>(points, decoders, at);
    }
    for (std::size_t k = 0; k < Count; ++k) {
        open[k].at = at[k];
        open[k].left -= common;
    }
}

std::vector<LazRecords> LazUnpacker::unpackTogether(std::span<const std::unique_ptr<LazUnpacker>> unpackers,
                                                    std::span<const LazChunk> chunks) {
    std::vector<LazRecords> records(chunks.size());
    // Layers are decoded beside each other as they are.
    if (chunks.size() < 2 || unpackers[0]->m_layered) {
        for (std::size_t k = 0; k < chunks.size(); ++k) {
            records[k] = unpackers[k]->unpack(chunks[k]);
        }
        return records;
    }
    const std::size_t bytes = unpackers[0]->m_head.recordBytes;
    std::vector<Lane> open;
    for (std::size_t k = 0; k < chunks.size(); ++k) {
        records[k] = unpackers[k]->roomFor(chunks[k]);
        LazChunk chunk = chunks[k];
        unpackers[k]->start(chunk, true, records[k]->data());
        open.push_back({&unpackers[k]->m_points, &*unpackers[k]->m_decoder, records[k]->data(), records[k]->size() / bytes - 1});
    }
    // The shortest ends first; the others go on together.
    std::sort(open.begin(), open.end(), [](const Lane& one, const Lane& other) { return one.left > other.left; });
    for (; !open.empty(); open.pop_back()) {
        if (open.size() == lanes) {
            unpackLanes<lanes>(open, bytes);
        } else if (open.size() == 2) {
            unpackLanes<2>(open, bytes);
        }
        Lane& shortest = open.back();
        for (; shortest.left > 0; --shortest.left) {
            shortest.at += bytes;
            shortest.points->decode(*shortest.decoder, shortest.at);
        }
    }
    for (std::size_t k = 0; k < chunks.size(); ++k) {
        if (unpackers[k]->overrun()) {
            records[k].reset();
        }
    }
    return records;
}

}  // namespace rubble::io
