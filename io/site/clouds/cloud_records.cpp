#include "io/site/clouds/cloud_records.h"

#include <algorithm>
#include <utility>

#include "io/base/file_words.h"

namespace rubble::io {

namespace {

double storedAt(const unsigned char* bytes, const StoredColumn& column, bool bigEndian) {
    const NumberType type = column.floatBits ? NumberType{NumberType::Kind::Unsigned, 4} : column.type;
    return numberAt(bytes, type, bigEndian);
}

bool keptSingly(const StoredPoints& points) {
    return std::any_of(points.columns.begin(), points.columns.end(), [](const StoredColumn& column) {
        return column.role == ColumnRole::X && column.type.kind == NumberType::Kind::Real && column.type.bytes == sizeof(float);
    });
}

/// Fills a block with points. @param bytes  behind which the columns start
void fillBlock(const unsigned char* bytes, const StoredPoints& points, std::size_t count, CloudHead& head, CloudBlock& block) {
    block.clear();
    block.resize(count, head.columns);
    for (const StoredColumn& column : points.columns) {
        for (std::size_t i = 0; column.role != ColumnRole::Unread && i < count; ++i) {
            const unsigned char* at = bytes + column.start + i * column.step;
            ColumnPlan::put(block, i, column.role, storedAt(at, column, points.bigEndian), column.colourScale);
        }
    }
    if (keptSingly(points)) {
        head.step = std::max(head.step, stepOfBlock(block));
    }
}

class RecordsSource final : public CloudSource {
public:
    RecordsSource(std::unique_ptr<CloudFile> file, StoredPoints points, CloudHead head, Findings found)
        : m_file(std::move(file)), m_points(std::move(points)), m_step(m_points.columns.front().step) {
        m_head = std::move(head);
        m_findings = std::move(found);
        m_head.promised = m_points.count;
        // A record begins where the first of its numbers lies.
        m_at = m_file->size();
        for (const StoredColumn& column : m_points.columns) {
            m_at = std::min(m_at, column.start);
        }
        for (StoredColumn& column : m_points.columns) {
            column.start -= m_at;
        }
        m_left = std::min((m_file->size() - m_at) / m_step, m_points.count);
        if (m_left < m_points.count) {
            addFinding(m_findings, m_file->path(),
                       {"cloud.fewer_points",
                        "the head says {0} points, the file has {1}",
                        {static_cast<std::int64_t>(m_points.count), static_cast<std::int64_t>(m_left)}},
                       "the file may be cut short: copy it again from where it came");
        }
    }

    bool next(CloudBlock& block, const Execution& execution) override {
        execution.check();
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(m_left, cloudBlockPoints));
        m_bytes.resize(static_cast<std::size_t>(count * m_step));
        m_file->read(m_at, m_bytes.data(), m_bytes.size());
        fillBlock(m_bytes.data(), m_points, count, m_head, block);
        m_at += m_bytes.size();
        m_left -= count;
        return count > 0;
    }

private:
    std::unique_ptr<CloudFile> m_file;
    StoredPoints m_points;
    std::uint64_t m_step;
    std::uint64_t m_at = 0;
    std::uint64_t m_left = 0;
    std::vector<unsigned char> m_bytes;
};

class UnpackedSource final : public CloudSource {
public:
    UnpackedSource(std::vector<unsigned char> bytes, StoredPoints points, CloudHead head, Findings found)
        : m_bytes(std::move(bytes)), m_points(std::move(points)), m_left(m_points.count) {
        m_head = std::move(head);
        m_findings = std::move(found);
        m_head.promised = m_points.count;
    }

    bool next(CloudBlock& block, const Execution& execution) override {
        execution.check();
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(m_left, cloudBlockPoints));
        fillBlock(m_bytes.data(), m_points, count, m_head, block);
        for (StoredColumn& column : m_points.columns) {
            column.start += count * column.step;
        }
        m_left -= count;
        return count > 0;
    }

private:
    std::vector<unsigned char> m_bytes;
    StoredPoints m_points;
    std::uint64_t m_left;
};

}  // namespace

std::unique_ptr<CloudSource> recordsCloud(std::unique_ptr<CloudFile> file, StoredPoints points, CloudHead head, Findings found) {
    return std::make_unique<RecordsSource>(std::move(file), std::move(points), std::move(head), std::move(found));
}

std::unique_ptr<CloudSource> unpackedCloud(std::vector<unsigned char> bytes, StoredPoints points, CloudHead head, Findings found) {
    return std::make_unique<UnpackedSource>(std::move(bytes), std::move(points), std::move(head), std::move(found));
}

}  // namespace rubble::io
