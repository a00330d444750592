#include "io/site/clouds/las/laz_source.h"

#include <algorithm>
#include <optional>

#include "core/base/message.h"
#include "io/site/clouds/las/las_records.h"
#include "io/site/clouds/las/laz_chunks.h"
#include "io/site/clouds/las/laz_points.h"
#include "io/site/file_words.h"

namespace rubble::io {

namespace {

class LazSource final : public CloudSource {
public:
    LazSource(std::unique_ptr<CloudFile> file, LasHead head, Findings found)
        : m_file(std::move(file)), m_las(std::move(head)), m_packing(readLazPacking(*m_file, m_las)), m_left(m_las.points) {
        m_findings = std::move(found);
        m_chunks = readLazChunks(*m_file, m_las, m_packing, m_findings);
        m_at = m_las.pointsStart + (m_packing.chunked ? sizeof(std::uint64_t) : 0);
        describeLas(*m_file, m_las, m_head);
        m_head.format = "LAZ";
        m_head.coding =
            "point format " + std::to_string(m_las.layout.format) + ", " + (m_packing.layered ? "layers" : "points") +
            (!m_packing.chunked           ? " without chunks"
             : m_packing.chunkPoints == 0 ? " in chunks of any size"
                                          : " in chunks of " + englishInteger(static_cast<std::int64_t>(m_packing.chunkPoints)));
        m_head.coding += m_las.record("copc", 1) != nullptr ? ", COPC" : "";
    }

    bool next(CloudBlock& block, const Execution& execution) override {
        execution.check();
        const auto most = static_cast<std::size_t>(std::min<std::uint64_t>(m_left, cloudBlockPoints));
        m_records.resize(most * m_las.recordBytes);
        std::size_t count = 0;
        while (count < most && !m_ended) {
            const std::size_t before = count;
            if (m_leftInChunk == 0 && !startChunk(m_records.data() + count * m_las.recordBytes, count)) {
                break;
            }
            for (; count < most && m_leftInChunk > 0; ++count, --m_leftInChunk) {
                decode(m_records.data() + count * m_las.recordBytes);
            }
            if (overrun()) {
                count = before;
                endAt(count);
            }
        }
        m_left -= count;
        decodeLasRecords(m_las, m_records.data(), count, block);
        return count > 0;
    }

private:
    void decode(unsigned char* record) { m_packing.layered ? m_layers.decode(record) : m_points.decode(*m_decoder, record); }

    /// Begins the next chunk and takes its first point. @return false: there is none
    bool startChunk(unsigned char* record, std::size_t& count) {
        if (m_bytes) {
            m_at = m_bytes->position();
        }
        LazChunk chunk{m_at, m_file->size(), m_packing.chunkPoints};
        if (!m_chunks.empty()) {
            do {
                if (m_nextChunk == m_chunks.size()) {
                    return false;
                }
                chunk = m_chunks[m_nextChunk++];
            } while (chunk.points == 0);
        } else if (m_at >= m_file->size() || m_file->size() - m_at < m_las.recordBytes) {
            endAt(count);
            return false;
        }
        if (!(m_packing.layered ? startLayers(chunk, record) : startPoints(chunk, record, m_left > count + 1))) {
            endAt(count);
            return false;
        }
        ++count;
        m_leftInChunk = chunk.points - 1;
        return true;
    }

    bool startLayers(LazChunk& chunk, unsigned char* record) {
        if (!m_layers.start(*m_file, chunk.start, record)) {
            return false;
        }
        m_at = m_layers.end();
        chunk.points = !m_chunks.empty() ? chunk.points : m_layers.points();
        return chunk.points > 0 && (chunk.points == 1 || m_layers.holdsMore());
    }

    bool startPoints(const LazChunk& chunk, unsigned char* record, bool more) {
        m_bytes.emplace(*m_file, chunk.start, chunk.end);
        m_bytes->take(record, m_las.recordBytes);
        m_points.start(record);
        m_decoder.emplace(*m_bytes);
        if (chunk.points > 1 && more) {
            m_decoder->start();
        }
        return true;
    }

    bool overrun() const { return m_packing.layered ? m_layers.overrun() : m_bytes && m_bytes->overrun(); }

    /// Without a table the file was cut, and what is there is told; with one it is damaged.
    /// @param count  points of this block that are sound
    void endAt(std::size_t count) {
        const std::uint64_t sound = m_las.points - m_left + count;
        if (!m_chunks.empty()) {
            refuseContent({"cloud.laz_chunk",
                           "{0} is damaged: the packed points behind point {1} cannot be unpacked",
                           {m_file->path(), static_cast<std::int64_t>(sound)}},
                          "Copy it again from where it came.");
        }
        addFinding(m_findings, m_file->path(),
                   {"cloud.fewer_points",
                    "the head says {0} points, the file has {1}",
                    {static_cast<std::int64_t>(m_las.points), static_cast<std::int64_t>(sound)}},
                   "the file may be cut short: copy it again from where it came");
        m_ended = true;
    }

    std::unique_ptr<CloudFile> m_file;
    LasHead m_las;
    LazPacking m_packing;
    std::vector<LazChunk> m_chunks;
    std::size_t m_nextChunk = 0;
    std::uint64_t m_at = 0;  ///< of the next chunk, where no table says it
    std::uint64_t m_left = 0;
    std::uint64_t m_leftInChunk = 0;
    bool m_ended = false;  ///< before all points were read
    std::vector<unsigned char> m_records;
    std::optional<PackedBytes> m_bytes;
    std::optional<ArithmeticDecoder> m_decoder;
    LazPoints m_points{m_las};
    LazLayers m_layers{m_las, m_packing.turns};
};

}  // namespace

std::unique_ptr<CloudSource> openLaz(std::unique_ptr<CloudFile> file, LasHead head, Findings found) {
    return std::make_unique<LazSource>(std::move(file), std::move(head), std::move(found));
}

}  // namespace rubble::io
