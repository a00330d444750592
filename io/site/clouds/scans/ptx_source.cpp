#include "io/site/clouds/scans/ptx_source.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/base/file_words.h"
#include "io/site/clouds/cloud_lines.h"

namespace rubble::io {

namespace {

/// Scans follow one another with heads of their own, which are met while the points are read.
class PtxSource final : public CloudSource {
public:
    explicit PtxSource(const std::string& path) : m_file(std::make_shared<CloudFile>(path)), m_lines(m_file, 0), m_path(path) {
        m_head.format = "PTX";
        m_head.coding = "text";
        m_head.columns.intensity = m_head.columns.colour = m_head.columns.scans = true;
        m_head.fullColour = 255.0;
        readScans();
    }

    bool next(CloudBlock& block, const Execution& execution) override {
        execution.check();
        block.clear();
        block.resize(cloudBlockPoints, m_head.columns);
        block.fates.assign(cloudBlockPoints, PointFate::Taken);
        std::size_t count = 0;
        std::string_view line;
        while (count < cloudBlockPoints && startScan() && m_lines.next(line)) {
            if (!line.empty()) {
                --m_left;
                count += takeLine(line, block, count) ? 1 : 0;
            }
        }
        if (count < cloudBlockPoints) {
            finish();
        }
        std::vector<PointFate> fates(block.fates.begin(), block.fates.begin() + static_cast<std::ptrdiff_t>(count));
        block.resize(count, m_head.columns);
        block.fates = std::move(fates);
        return count > 0;
    }

private:
    static constexpr std::size_t headLines = 10;
    using HeadNumbers = std::array<std::array<double, 4>, headLines>;

    struct Scan {
        Eigen::Affine3d toSite = Eigen::Affine3d::Identity();
        std::uint64_t points = 0;  ///< lines that are there
        std::uint64_t start = 0;   ///< of its first point in the file
    };

    [[noreturn]] void refuse(std::size_t scan) const {
        refuseContent({"cloud.ptx", "{0}: scan {1} does not begin with columns, rows, a scanner and a matrix", {m_path, scan}},
                      "Export the scans anew as PTX or E57.");
    }

    /// Finds all heads, so that the scans are known before their points are.
    void readScans() {
        CloudLines lines(m_file, 0);
        std::string_view line;
        constexpr std::size_t scansMost = 65'535;
        std::uint64_t promised = 0;
        bool colour = false;
        bool more = firstLine(lines, line);
        while (more && m_scans.size() < scansMost) {
            Scan scan;
            CloudScan told;
            told.promised = readHead(lines, line, scan, told);
            scan.start = lines.position();
            promised += told.promised;
            for (more = firstLine(lines, line); more && scan.points < told.promised; more = firstLine(lines, line)) {
                // A number alone is the head of the next scan, which comes too soon.
                if (line.find_first_of(" \t") == std::string_view::npos) {
                    break;
                }
                colour = colour || (scan.points == 0 && fieldsIn(line, {}, m_fields, 7) >= 7);
                ++scan.points;
            }
            m_scans.push_back(scan);
            m_head.scans.push_back(std::move(told));
        }
        m_head.columns.colour = colour;
        m_head.promised = promised;
    }

    static bool firstLine(CloudLines& lines, std::string_view& line) {
        while (lines.next(line)) {
            if (!line.empty()) {
                return true;
            }
        }
        return false;
    }

    /// @param line  the first of the head @return points of the scan
    std::uint64_t readHead(CloudLines& lines, std::string_view line, Scan& scan, CloudScan& told) {
        HeadNumbers numbers{};
        constexpr std::array<std::size_t, headLines> widths{1, 1, 3, 3, 3, 3, 4, 4, 4, 4};
        for (std::size_t row = 0; row < headLines; ++row) {
            if ((row > 0 && !lines.next(line)) || fieldsIn(line, {}, m_fields, 4) != widths[row]) {
                refuse(m_scans.size() + 1);
            }
            for (std::size_t k = 0; k < widths[row]; ++k) {
                numbers[row][k] = fieldNumber(m_fields[k], {});
                if (!std::isfinite(numbers[row][k])) {
                    refuse(m_scans.size() + 1);
                }
            }
        }
        // Points are rows, and the matrix stands behind them.
        for (Eigen::Index i = 0; i < 4; ++i) {
            for (Eigen::Index j = 0; j < 3; ++j) {
                scan.toSite.matrix()(j, i) = numbers[6 + static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
            }
        }
        told.pose.stated = told.pose.applied = true;
        told.pose.position = scan.toSite.translation();
        if (scan.toSite.isApprox(Eigen::Affine3d::Identity())) {
            takeScannerOfHead(numbers, told.pose);
        } else if (!takeTurn(scan.toSite.linear(), told.pose)) {
            addFinding(m_findings, m_path,
                       {"cloud.matrix_no_rotation", "the matrix of a scan scales or shears; it was applied as it is", {}},
                       "compare a length in the cloud with what is known, and export the scans anew");
        }
        constexpr double most = 1e12;
        const double points = numbers[0][0] * numbers[1][0];
        if (!(numbers[0][0] >= 0.0 && numbers[1][0] >= 0.0 && points < most)) {
            refuse(m_scans.size() + 1);
        }
        return static_cast<std::uint64_t>(points);
    }

    /// Points that lie at their places already have a matrix that does nothing; the scanner and its axes may still be told.
    static void takeScannerOfHead(const HeadNumbers& numbers, CloudPose& pose) {
        Mat3 axes;
        for (std::size_t i = 0; i < 3; ++i) {
            pose.position[static_cast<Eigen::Index>(i)] = numbers[2][i];
            axes.col(static_cast<Eigen::Index>(i)) = Vec3(numbers[3 + i][0], numbers[3 + i][1], numbers[3 + i][2]);
        }
        takeTurn(axes, pose);
    }

    /// @return false: it is no rotation, and is not taken
    static bool takeTurn(const Mat3& turn, CloudPose& pose) {
        constexpr double turnError = 1e-3;
        const bool rotates =
            (turn * turn.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff() < turnError && turn.determinant() > 0.0;
        pose.orientation = rotates ? Quat(turn).normalized() : Quat::Identity();
        return rotates;
    }

    /// @return whether a scan has points left
    bool startScan() {
        while (m_left == 0 && m_next < m_scans.size()) {
            m_lines = CloudLines(m_file, m_scans[m_next].start);
            m_left = m_scans[m_next++].points;
        }
        return m_left > 0;
    }

    bool takeLine(std::string_view line, CloudBlock& block, std::size_t i) {
        if (fieldsIn(line, {}, m_fields, 7) < 4) {
            m_unread.add(m_lines.position());
            return false;
        }
        const auto number = [this](std::size_t k) { return fieldNumber(m_fields[k], {}); };
        const Vec3 place(number(0), number(1), number(2));
        block.fates[i] = place.isZero(0.0) ? PointFate::NoReturn : PointFate::Taken;
        block.places[i] = m_scans[m_next - 1].toSite * place;
        block.intensity[i] = static_cast<float>(number(3));
        block.scans[i] = static_cast<std::uint16_t>(m_next - 1);
        for (std::size_t channel = 0; !block.colours.empty() && channel < 3; ++channel) {
            const double step = m_fields.size() >= 7 ? number(4 + channel) : 0.0;
            block.colours[i][channel] = step > 0.0 ? static_cast<std::uint16_t>(std::min(step, 255.0)) : 0;
        }
        ++m_taken;
        return true;
    }

    void finish() {
        if (!m_told) {
            m_unread.tell(*m_file, m_findings);
        }
        if (const std::uint64_t promised = m_head.promised.value_or(0); promised > m_taken && !m_told) {
            addFinding(m_findings, m_path,
                       {"cloud.fewer_points",
                        "the head says {0} points, the file has {1}",
                        {static_cast<std::int64_t>(promised), static_cast<std::int64_t>(m_taken)}},
                       "the file may be cut short: copy it again from where it came");
        }
        m_told = true;
    }

    std::shared_ptr<CloudFile> m_file;
    CloudLines m_lines;
    std::string m_path;
    std::vector<Scan> m_scans;
    std::size_t m_next = 0;
    std::uint64_t m_left = 0;  ///< lines of the scan that is read
    std::uint64_t m_taken = 0;
    UnreadLines m_unread;
    bool m_told = false;
    std::vector<std::string_view> m_fields;
};

}  // namespace

std::unique_ptr<CloudSource> openPtx(const std::string& path) {
    return std::make_unique<PtxSource>(path);
}

}  // namespace rubble::io
