#include "io/site/clouds/las/laz_source.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <span>
#include <thread>

#include "core/base/message.h"
#include "io/base/file_words.h"
#include "io/site/clouds/las/las_records.h"
#include "io/site/clouds/las/laz_chunks.h"
#include "io/site/clouds/las/laz_unpacker.h"

namespace rubble::io {

namespace {

class LazSource final : public CloudSource {
public:
    LazSource(std::unique_ptr<CloudFile> file, LasHead head, Findings found)
        : m_file(std::move(file)), m_las(std::move(head)), m_packing(readLazPacking(*m_file, m_las)), m_left(m_las.points) {
        m_findings = std::move(found);
        m_chunks = readLazChunks(*m_file, m_las, m_packing, m_findings);
        for (const LazChunk& chunk : m_chunks) {
            m_largest = std::max(m_largest, chunk.points);
        }
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
        const std::size_t count = fitsMemory() ? takeUnpacked(block, most, execution.threads()) : unpack(block, most);
        m_left -= count;
        return count > 0;
    }

private:
    /// Chunks that a table names are unpacked some at a time by each thread; larger ones than usual would take too much memory.
    bool fitsMemory() const {
        constexpr std::uint64_t bytesMost = std::uint64_t{8} << 20;
        return !m_chunks.empty() && m_largest * m_las.recordBytes <= bytesMost;
    }

    /// Points of the chunks that were unpacked together; unpacks the next ones if there are none left.
    std::size_t takeUnpacked(CloudBlock& block, std::size_t most, int threads) {
        while (m_together.empty() && m_nextChunk < m_chunks.size()) {
            unpackTogether(static_cast<std::size_t>(std::min(threads, 16)));
        }
        if (m_together.empty()) {
            decodeLasRecords(m_las, nullptr, 0, block);
            return 0;
        }
        const std::vector<unsigned char>& records = m_together.front();
        const std::size_t count = std::min(most, records.size() / m_las.recordBytes - m_taken);
        decodeLasRecords(m_las, records.data() + m_taken * m_las.recordBytes, count, block);
        m_taken += count;
        if (m_taken * m_las.recordBytes == records.size()) {
            m_unpackers[m_together.size() - 1]->reuse(std::move(m_together.front()));
            m_together.erase(m_together.begin());
            m_taken = 0;
        }
        return count;
    }

    void unpackTogether(std::size_t threads) {
        std::vector<LazChunk> chunks;
        constexpr std::size_t lanes = LazUnpacker::lanes;
        for (; chunks.size() < lanes * threads && m_nextChunk < m_chunks.size(); ++m_nextChunk) {
            if (m_chunks[m_nextChunk].points > 0) {
                chunks.push_back(m_chunks[m_nextChunk]);
            }
        }
        while (m_unpackers.size() < chunks.size()) {
            m_unpackers.push_back(std::make_unique<LazUnpacker>(*m_file, m_las, m_packing));
        }
        std::vector<LazRecords> made(chunks.size());
        std::vector<std::exception_ptr> failures(chunks.size());
        const auto work = [&](std::size_t c) {
            try {
                const std::size_t count = std::min(lanes, chunks.size() - c);
                std::vector<LazRecords> some =
                    LazUnpacker::unpackTogether(std::span(m_unpackers).subspan(c, count), std::span(chunks).subspan(c, count));
                std::move(some.begin(), some.end(), made.begin() + static_cast<std::ptrdiff_t>(c));
            } catch (...) {
                failures[c] = std::current_exception();
            }
        };
        {
            std::vector<std::jthread> workers;
            for (std::size_t c = lanes; c < chunks.size(); c += lanes) {
                workers.emplace_back([&work, c] { work(c); });
            }
            if (!chunks.empty()) {
                work(0);
            }
        }
        std::size_t sound = 0;
        for (std::size_t c = 0; c < chunks.size(); ++c) {
            if (failures[c]) {
                std::rethrow_exception(failures[c]);
            }
            if (!made[c]) {
                endAt(sound);
            }
            sound += static_cast<std::size_t>(chunks[c].points);
            m_together.push_back(std::move(*made[c]));
        }
    }

    /// Unpacks the next points by this thread alone.
    std::size_t unpack(CloudBlock& block, std::size_t most) {
        m_records.resize(most * m_las.recordBytes);
        std::size_t count = 0;
        while (count < most && !m_ended) {
            const std::size_t before = count;
            if (m_leftInChunk == 0 && !startChunk(m_records.data() + count * m_las.recordBytes, count)) {
                break;
            }
            for (; count < most && m_leftInChunk > 0; ++count, --m_leftInChunk) {
                m_unpacker.decode(m_records.data() + count * m_las.recordBytes);
            }
            if (m_unpacker.overrun()) {
                count = before;
                endAt(count);
            }
        }
        decodeLasRecords(m_las, m_records.data(), count, block);
        return count;
    }

    /// Begins the next chunk and takes its first point. @return false: there is none
    bool startChunk(unsigned char* record, std::size_t& count) {
        if (m_started) {
            m_at = m_unpacker.end();
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
        // The last chunk may be shorter than the others.
        chunk.points = m_packing.layered ? chunk.points : std::min(chunk.points, m_left - count);
        if (!m_unpacker.start(chunk, !m_chunks.empty(), record)) {
            endAt(count);
            return false;
        }
        m_started = true;
        ++count;
        m_leftInChunk = chunk.points - 1;
        return true;
    }

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
    bool m_started = false;
    std::vector<unsigned char> m_records;
    LazUnpacker m_unpacker{*m_file, m_las, m_packing};

    std::uint64_t m_largest = 0;  ///< points of the largest chunk
    std::vector<std::unique_ptr<LazUnpacker>> m_unpackers;
    std::vector<std::vector<unsigned char>> m_together;  ///< chunks that were unpacked at once
    std::size_t m_taken = 0;                             ///< points of the first of them
};

}  // namespace

std::unique_ptr<CloudSource> openLaz(std::unique_ptr<CloudFile> file, LasHead head, Findings found) {
    return std::make_unique<LazSource>(std::move(file), std::move(head), std::move(found));
}

}  // namespace rubble::io
