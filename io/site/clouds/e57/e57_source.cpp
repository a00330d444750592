#include "io/site/clouds/e57/e57_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "io/base/file_words.h"
#include "io/site/clouds/e57/e57_columns.h"

namespace rubble::io {

namespace {

/// Columns that are kept, by the names of the standard.
enum E57Role : std::uint8_t {
    CartesianX,
    CartesianY,
    CartesianZ,
    CartesianState,
    Range,
    Azimuth,
    Elevation,
    SphericalState,
    Brightness,
    BrightnessState,
    Red,
    Green,
    Blue,
    ColourState,
    EchoIndex,
    EchoCount,
    Stamp,
    Kind,
    roleCount
};
constexpr std::array<std::string_view, roleCount> roleNames{
    "cartesianX",     "cartesianY",         "cartesianZ",         "cartesianInvalidState",
    "sphericalRange", "sphericalAzimuth",   "sphericalElevation", "sphericalInvalidState",
    "intensity",      "isIntensityInvalid", "colorRed",           "colorGreen",
    "colorBlue",      "isColorInvalid",     "returnIndex",        "returnCount",
    "timeStamp",      "classification"};

constexpr std::size_t noColumn = ~std::size_t{0};

/// The role of a column; none: roleCount. A classification may stand in a name space of its own.
std::size_t roleOf(std::string_view name) {
    const std::size_t colon = name.find(':');
    const std::string_view bare = colon == std::string_view::npos ? name : name.substr(colon + 1);
    const auto found = std::find(roleNames.begin(), roleNames.end(), bare == "classification" ? bare : name);
    return static_cast<std::size_t>(found - roleNames.begin());
}

class E57Source final : public CloudSource {
public:
    explicit E57Source(const std::string& path) : m_pages(path), m_e57(readE57Head(m_pages, m_findings)) {
        m_head.format = "E57";
        m_head.version = m_pages.version();
        m_head.coding = std::to_string(m_e57.scans.size()) + (m_e57.scans.size() == 1 ? " scan" : " scans");
        m_head.crs = m_e57.crs;
        m_head.crsFrom = m_e57.crs.empty() ? "" : "WKT";
        m_head.metresByFormat = true;
        m_head.columns.scans = true;
        m_head.photographs = m_e57.photographs;
        std::uint64_t promised = 0;
        double mostColour = 0.0;
        for (const CloudScan& scan : m_e57.scans) {
            promised += scan.promised;
        }
        for (const E57Points& points : m_e57.points) {
            noteFields(points);
            mostColour = std::max(mostColour, colourLimits(points).second);
        }
        m_head.promised = promised;
        m_head.fullColour = mostColour > 255.0 ? 65535.0 : 255.0;
        m_head.scans = m_e57.scans;
        requireScans();
        notePoses();
    }

    bool next(CloudBlock& block, const Execution& execution) override {
        for (; m_scan < m_e57.scans.size(); ++m_scan, m_columns.reset()) {
            execution.check();
            if (!m_columns && !startScan()) {
                continue;
            }
            const std::uint64_t wanted = std::min<std::uint64_t>(m_left, cloudBlockPoints);
            const std::uint64_t ready = m_columns->fill(wanted);
            if (ready > 0) {
                m_left -= ready;
                take(static_cast<std::size_t>(ready), block);
                return true;
            }
            if (wanted > 0) {
                tellFewer(m_e57.points[m_scan].records, m_e57.points[m_scan].records - m_left);
            }
        }
        block.clear();
        return false;
    }

private:
    void tellFewer(std::uint64_t promised, std::uint64_t there) {
        addFinding(m_findings, m_pages.path(),
                   {"cloud.fewer_points",
                    "the head says {0} points, the file has {1}",
                    {static_cast<std::int64_t>(promised), static_cast<std::int64_t>(there)}},
                   "the file may be cut short: copy it again from where it came");
    }

    /// Several scans are brought together by their poses alone.
    void notePoses() {
        const auto missing =
            std::count_if(m_e57.scans.begin(), m_e57.scans.end(), [](const CloudScan& scan) { return !scan.pose.stated; });
        if (m_e57.scans.size() > 1 && missing > 0) {
            addFinding(m_findings, m_pages.path(), {"cloud.pose_missing", "scans without a pose are taken as placed already", {}},
                       "look whether the scans fit together; export them anew with their registration", missing);
        }
    }

    void requireScans() const {
        constexpr std::size_t scansMost = 65'535;
        if (m_e57.scans.size() > scansMost) {
            refuseContent({"cloud.e57_scans", "{0} holds {1} scans; 65,535 can be read", {m_pages.path(), m_e57.scans.size()}},
                          "Part it into several files.");
        }
    }

    void noteFields(const E57Points& points) {
        for (const E57Field& field : points.fields) {
            const std::size_t role = roleOf(field.name);
            m_head.columns.intensity = m_head.columns.intensity || role == Brightness;
            m_head.columns.colour = m_head.columns.colour || role == Red;
            m_head.columns.returns = m_head.columns.returns || role == EchoIndex;
            m_head.columns.times = m_head.columns.times || role == Stamp;
            m_head.columns.classes = m_head.columns.classes || role == Kind;
            if (role == roleCount && std::find(m_head.unread.begin(), m_head.unread.end(), field.name) == m_head.unread.end()) {
                m_head.unread.push_back(field.name);
            }
        }
    }

    /// Least and greatest step of colours of a scan: stated, or by the limits of its numbers.
    static std::pair<double, double> colourLimits(const E57Points& points) {
        if (points.colourMost > points.colourLeast) {
            return {points.colourLeast, points.colourMost};
        }
        const auto red = std::find_if(points.fields.begin(), points.fields.end(),
                                      [](const E57Field& field) { return field.name == roleNames[Red]; });
        if (red == points.fields.end() || red->kind != E57Field::Kind::Whole || red->bits > 16) {
            return {0.0, red == points.fields.end() ? 0.0 : 255.0};
        }
        const auto least = static_cast<double>(red->least);
        return {least, least + std::ldexp(1.0, static_cast<int>(red->bits)) - 1.0};
    }

    /// @return whether the scan has points with places
    bool startScan() {
        const E57Points& points = m_e57.points[m_scan];
        m_left = points.records;
        if (m_left == 0) {
            return false;
        }
        m_columnOf.fill(noColumn);
        std::uint64_t bits = 0;
        std::vector<bool> kept(points.fields.size());
        for (std::size_t f = 0; f < points.fields.size(); ++f) {
            bits += points.fields[f].bits;
            const std::size_t role = roleOf(points.fields[f].name);
            kept[f] = role < roleCount && points.fields[f].kind != E57Field::Kind::Text;
            if (kept[f]) {
                m_columnOf[role] = f;
            }
        }
        m_cartesian = has(CartesianX) && has(CartesianY) && has(CartesianZ);
        if (!m_cartesian && !(has(Range) && has(Azimuth) && has(Elevation))) {
            addFinding(m_findings, m_pages.path(),
                       {"cloud.scan_without_places", "scans without places of their points were left out", {}},
                       "none is needed if the other scans are what is wanted");
            return false;
        }
        // Points that take no bits would have no end.
        if (bits == 0 && m_left > cloudBlockPoints) {
            m_left = cloudBlockPoints;
            tellFewer(points.records, m_left);
        }
        m_columns.emplace(m_pages, points, kept);
        m_values.resize(points.fields.size());
        std::tie(m_colourLeast, m_colourMost) = colourLimits(points);
        return true;
    }

    bool has(E57Role role) const { return m_columnOf[role] != noColumn; }
    const std::vector<double>& values(E57Role role) const { return m_values[m_columnOf[role]]; }

    void take(std::size_t count, CloudBlock& block) {
        for (std::size_t c = 0; c < m_columns->count(); ++c) {
            m_columns->column(c).take(count, m_values[c]);
        }
        block.clear();
        block.resize(count, m_head.columns);
        block.fates.assign(count, PointFate::Taken);
        std::fill(block.scans.begin(), block.scans.end(), static_cast<std::uint16_t>(m_scan));
        takePlaces(block);
        takeLooks(block);
        takeRest(block);
    }

    void takePlaces(CloudBlock& block) {
        const CloudPose& pose = m_e57.scans[m_scan].pose;
        const E57Role state = m_cartesian ? CartesianState : SphericalState;
        for (std::size_t i = 0; i < block.size(); ++i) {
            Vec3& place = block.places[i];
            if (m_cartesian) {
                place = {values(CartesianX)[i], values(CartesianY)[i], values(CartesianZ)[i]};
            } else {
                const double range = values(Range)[i];
                const double azimuth = values(Azimuth)[i];
                const double elevation = values(Elevation)[i];
                place = range *
                        Vec3(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
            }
            if (has(state) && values(state)[i] != 0.0) {
                block.fates[i] = PointFate::Invalid;
            } else if (pose.stated && place.isZero(0.0)) {
                block.fates[i] = PointFate::NoReturn;
            }
            if (pose.stated) {
                place = pose * place;
            }
        }
    }

    void takeLooks(CloudBlock& block) {
        for (std::size_t i = 0; has(Brightness) && i < block.size(); ++i) {
            const bool known = !has(BrightnessState) || values(BrightnessState)[i] == 0.0;
            block.intensity[i] = known ? static_cast<float>(values(Brightness)[i]) : 0.0F;
        }
        if (!has(Red) || !has(Green) || !has(Blue)) {
            return;
        }
        const double scale = m_head.fullColour / (m_colourMost - m_colourLeast);
        for (std::size_t i = 0; i < block.size(); ++i) {
            const bool known = !has(ColourState) || values(ColourState)[i] == 0.0;
            for (std::size_t channel = 0; channel < 3 && known; ++channel) {
                const double value = values(static_cast<E57Role>(Red + channel))[i];
                const double step = std::round((value - m_colourLeast) * scale);
                block.colours[i][channel] = step > 0.0 ? static_cast<std::uint16_t>(std::min(step, m_head.fullColour)) : 0;
            }
        }
    }

    void takeRest(CloudBlock& block) {
        const auto whole = [](double value, double most) { return value > 0.0 ? std::min(value, most) : 0.0; };
        for (std::size_t i = 0; has(EchoIndex) && i < block.size(); ++i) {
            const double echoes = has(EchoCount) ? whole(values(EchoCount)[i], 255.0) : 255.0;
            // The standard counts from 0; programs that count from 1 are told by an echo beyond the last.
            const double echo = std::min(whole(values(EchoIndex)[i], 254.0) + 1.0, std::max(echoes, 1.0));
            block.returns[i] = static_cast<std::uint8_t>(echo);
            block.returnsOf[i] = static_cast<std::uint8_t>(has(EchoCount) ? echoes : 0.0);
        }
        for (std::size_t i = 0; has(Stamp) && i < block.size(); ++i) {
            block.times[i] = values(Stamp)[i];
        }
        for (std::size_t i = 0; has(Kind) && i < block.size(); ++i) {
            block.classes[i] = static_cast<std::uint16_t>(whole(values(Kind)[i], 65'535.0));
        }
    }

    E57Pages m_pages;
    E57Head m_e57;
    std::size_t m_scan = 0;
    std::uint64_t m_left = 0;  ///< of this scan
    std::optional<E57Columns> m_columns;
    std::vector<std::vector<double>> m_values;  ///< of each column
    std::array<std::size_t, roleCount> m_columnOf{};
    bool m_cartesian = true;
    double m_colourLeast = 0.0;
    double m_colourMost = 0.0;
};

}  // namespace

std::unique_ptr<CloudSource> openE57(const std::string& path) {
    return std::make_unique<E57Source>(path);
}

std::vector<unsigned char> photographOfE57(const std::string& path, const CloudPhotograph& photograph) {
    constexpr std::uint64_t sectionHead = 16;
    E57Pages pages(path);
    return pages.bytes(pages.placeOf(photograph.start) + sectionHead, photograph.bytes);
}

}  // namespace rubble::io
