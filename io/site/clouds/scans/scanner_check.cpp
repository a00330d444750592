#include "io/site/clouds/scans/scanner_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble::io {

namespace {

constexpr std::size_t rangeColumns = 720;  // half a degree
constexpr std::size_t rangeRows = 360;
/// Ranges of 1 MB each that are held at once.
constexpr std::size_t openMost = 64;
/// Level ground within half a degree goes on by a quarter of its range where that is fifty times the height of the scanner.
constexpr double sameRange = 1.25;
constexpr std::uint64_t comparedLeast = 50;

bool turnsNothing(const CloudPose& pose) {
    return pose.orientation.angularDistance(Quat::Identity()) < 1e-9;
}

std::size_t cellOf(const Vec3& along) {
    const double azimuth = std::atan2(along.y(), along.x()) / (2.0 * std::numbers::pi) + 0.5;
    const double elevation = std::atan2(along.z(), along.head<2>().norm()) / std::numbers::pi + 0.5;
    const auto column = static_cast<std::size_t>(azimuth * static_cast<double>(rangeColumns));
    const auto row = static_cast<std::size_t>(elevation * static_cast<double>(rangeRows));
    return std::min(row, rangeRows - 1) * rangeColumns + std::min(column, rangeColumns - 1);
}

}  // namespace

bool ScannerCheck::Looked::beyond() const {
    return !box.isEmpty() && box.exteriorDistance(place) > box.diagonal().norm();
}

bool ScannerCheck::Looked::seesThrough() const {
    return compared >= comparedLeast && 2 * different > compared;
}

ScannerCheck::ScannerCheck(const CloudHead& head) : m_scans(head.scans.size()), m_each(head.columns.scans) {
    // Which scan a point is of must be known, and what is a length.
    const bool told = (m_each || head.scans.size() == 1) && !head.units.degrees && !head.units.geocentric;
    for (std::size_t s = 0; s < m_scans.size(); ++s) {
        const CloudPose& pose = head.scans[s].pose;
        m_scans[s].stated = pose.stated;
        m_scans[s].doubted = pose.stated && told && turnsNothing(pose);
        m_scans[s].place = pose.position;
    }
}

void ScannerCheck::add(const CloudBlock& block) {
    if (std::none_of(m_scans.begin(), m_scans.end(), [](const Looked& scan) { return scan.doubted; })) {
        return;
    }
    for (std::size_t i = 0; i < block.size(); ++i) {
        look(m_each ? block.scans[i] : 0, block.places[i]);
    }
}

void ScannerCheck::look(std::size_t scan, const Vec3& place) {
    Looked& looked = m_scans[scan];
    const Vec3 along = place - looked.place;
    const auto range = static_cast<float>(along.norm());
    // A point in the scanner is an echo that did not come.
    if (!looked.doubted || !(range > 0.0F)) {
        return;
    }
    looked.box.extend(place);
    if (looked.closed) {
        return;
    }
    if (looked.ranges.empty()) {
        open(scan);
    }
    float& nearest = looked.ranges[cellOf(along)];
    if (nearest > 0.0F) {
        ++looked.compared;
        looked.different += std::max(range, nearest) > sameRange * std::min(range, nearest) ? 1 : 0;
    }
    nearest = nearest > 0.0F ? std::min(nearest, range) : range;
}

void ScannerCheck::open(std::size_t scan) {
    if (m_open.size() == openMost) {
        Looked& first = m_scans[m_open.front()];
        first.closed = true;
        first.ranges = Ranges();
        m_open.pop_front();
    }
    m_open.push_back(scan);
    m_scans[scan].ranges.assign(rangeColumns * rangeRows, 0.0F);
}

std::vector<bool> ScannerCheck::posed() const {
    std::vector<bool> posed;
    for (const Looked& scan : m_scans) {
        posed.push_back(scan.stated && !(scan.doubted && (scan.beyond() || scan.seesThrough())));
    }
    return posed;
}

}  // namespace rubble::io
