#include "io/site/clouds/las/las_source.h"

#include <algorithm>
#include <vector>

#include "io/base/file_words.h"
#include "io/site/clouds/las/las_head.h"
#include "io/site/clouds/las/las_records.h"
#include "io/site/clouds/las/laz_source.h"

namespace rubble::io {

namespace {

/// Points of a LAS as they lie in the file.
class LasSource final : public CloudSource {
public:
    LasSource(std::unique_ptr<CloudFile> file, LasHead head, Findings found) : m_file(std::move(file)), m_las(std::move(head)) {
        m_findings = std::move(found);
        describeLas(*m_file, m_las, m_head);
        m_head.format = "LAS";
        m_head.coding = "point format " + std::to_string(m_las.layout.format);
        const std::uint64_t room = (m_file->size() - m_las.pointsStart) / m_las.recordBytes;
        m_left = std::min(room, m_las.points);
        if (m_left < m_las.points) {
            addFinding(m_findings, m_file->path(),
                       {"cloud.fewer_points",
                        "the head says {0} points, the file has {1}",
                        {static_cast<std::int64_t>(m_las.points), static_cast<std::int64_t>(m_left)}},
                       "the file may be cut short: copy it again from where it came");
        }
        m_at = m_las.pointsStart;
    }

    bool next(CloudBlock& block, const Execution& execution) override {
        execution.check();
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(m_left, cloudBlockPoints));
        m_bytes.resize(count * m_las.recordBytes);
        m_file->read(m_at, m_bytes.data(), m_bytes.size());
        decodeLasRecords(m_las, m_bytes.data(), count, block);
        m_at += m_bytes.size();
        m_left -= count;
        return count > 0;
    }

private:
    std::unique_ptr<CloudFile> m_file;
    LasHead m_las;
    std::uint64_t m_at = 0;
    std::uint64_t m_left = 0;
    std::vector<unsigned char> m_bytes;
};

}  // namespace

std::unique_ptr<CloudSource> openLas(const std::string& path) {
    auto file = std::make_unique<CloudFile>(path);
    Findings found;
    LasHead head = readLasHead(*file, found);
    if (head.record("lascompatible", 22204) != nullptr) {
        addFinding(found, path,
                   {"cloud.las_compatible",
                    "points of LAS 1.4 were written as older ones: classes above 31 and echoes beyond the seventh are not read",
                    {}},
                   "have it written anew as LAS 1.4 or LAZ without the compatibility mode");
    }
    if (head.packed) {
        return openLaz(std::move(file), std::move(head), std::move(found));
    }
    return std::make_unique<LasSource>(std::move(file), std::move(head), std::move(found));
}

}  // namespace rubble::io
