#include "io/site/clouds/text_source.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/base/file_words.h"
#include "io/fe/meshes/raw_mesh.h"

namespace rubble::io {

namespace {

class TextSource final : public CloudSource {
public:
    TextSource(std::shared_ptr<const CloudFile> file, std::uint64_t start, TextPoints points, CloudHead head, Findings found)
        : m_file(file), m_lines(std::move(file), start), m_points(std::move(points)) {
        m_head = std::move(head);
        m_findings = std::move(found);
        if (m_points.count) {
            m_head.promised = m_points.count;
        }
        for (std::size_t c = 0; c < m_points.plan.size(); ++c) {
            m_needed = m_points.plan.role(c) != ColumnRole::Unread ? c + 1 : m_needed;
        }
    }

    bool next(CloudBlock& block, const Execution& execution) override {
        execution.check();
        block.clear();
        block.resize(cloudBlockPoints, m_head.columns);
        std::size_t count = 0;
        std::string_view line;
        for (; m_points.skipped > 0 && m_lines.next(line); --m_points.skipped) {
        }
        while (count < cloudBlockPoints && linesLeft() && m_lines.next(line)) {
            if (line.empty() || line.starts_with('#') || line.starts_with("//")) {
                continue;
            }
            count += takeLine(line, block, count) ? 1 : 0;
        }
        block.resize(count, m_head.columns);
        m_taken += count;
        if (count == 0) {
            finish();
        }
        return count > 0;
    }

private:
    bool linesLeft() const { return !m_points.count || m_seen < *m_points.count; }

    bool takeLine(std::string_view line, CloudBlock& block, std::size_t i) {
        const std::size_t there = fieldsIn(line, m_points.form, m_fields, m_needed);
        if (there == 1 && m_points.countsBetween) {
            const double more = fieldNumber(m_fields.front(), m_points.form);
            m_head.promised = m_head.promised.value_or(0) + (more > 0.0 && more < 1e15 ? static_cast<std::uint64_t>(more) : 0);
            return false;
        }
        ++m_seen;
        if (there < m_needed) {
            m_unread.add(m_lines.position());
            return false;
        }
        const bool exponents = line.find_first_of("eE") != std::string_view::npos;
        for (std::size_t c = 0; c < m_needed; ++c) {
            const ColumnRole role = m_points.plan.role(c);
            if (role == ColumnRole::Unread) {
                continue;
            }
            const bool place = role >= ColumnRole::X && role <= ColumnRole::Z;
            const std::optional<double> read = fieldNumberIn(m_fields[c], m_points.form);
            if (place && !read) {
                m_unread.add(m_lines.position());
                return false;
            }
            const double number = read.value_or(std::numeric_limits<double>::quiet_NaN());
            ColumnPlan::put(block, i, role, number, m_points.colourScale);
            if (exponents && place && std::isfinite(number)) {
                m_head.step = std::max(m_head.step, stepOfText(m_fields[c], number));
            }
        }
        return true;
    }

    void finish() {
        m_unread.tell(*m_file, m_findings);
        const std::uint64_t promised = m_head.promised.value_or(0);
        if (promised > m_seen) {
            addFinding(m_findings, m_file->path(),
                       {"cloud.fewer_points",
                        "the head says {0} points, the file has {1}",
                        {static_cast<std::int64_t>(promised), static_cast<std::int64_t>(m_taken)}},
                       "the file may be cut short: copy it again from where it came");
        }
    }

    std::shared_ptr<const CloudFile> m_file;
    CloudLines m_lines;
    TextPoints m_points;
    std::size_t m_needed = 0;  ///< fields of a point
    std::vector<std::string_view> m_fields;
    std::uint64_t m_seen = 0;
    std::uint64_t m_taken = 0;
    UnreadLines m_unread;
};

}  // namespace

std::unique_ptr<CloudSource> textCloud(std::shared_ptr<const CloudFile> file, std::uint64_t start, TextPoints points,
                                       CloudHead head, Findings found) {
    return std::make_unique<TextSource>(std::move(file), start, std::move(points), std::move(head), std::move(found));
}

}  // namespace rubble::io
