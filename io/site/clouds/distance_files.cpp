#include "io/site/clouds/distance_files.h"

#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <ostream>

#include "io/base/files.h"
#include "io/site/gdal_session.h"
#include "io/site/system_way.h"

namespace rubble::io {

namespace {

using Bytes = std::vector<unsigned char>;

template <class Number>
void append(Bytes& bytes, Number number) {
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof number);
    std::memcpy(&bytes[at], &number, sizeof number);
}

/// A text in so many bytes, filled with zeros.
void appendText(Bytes& bytes, std::string_view text, std::size_t length) {
    for (std::size_t k = 0; k < length; ++k) {
        bytes.push_back(k < text.size() ? static_cast<unsigned char>(text[k]) : 0);
    }
}

std::uint8_t significance(const CoreDistance& core) {
    return std::isnan(core.detection) ? 255 : static_cast<std::uint8_t>(core.significant() ? 1 : 0);
}

double greatestSignificant(const CloudComparison& made) {
    double most = 0.0;
    for (const CoreDistance& core : made.distances) {
        most = core.significant() ? std::max(most, std::abs(core.distance)) : most;
    }
    return most;
}

/// Red above, blue below, grey where nothing is significant; each of a byte.
std::array<std::uint8_t, 3> colourOf(const CoreDistance& core, double most) {
    if (!core.significant()) {
        return {160, 160, 160};
    }
    const auto pale = static_cast<std::uint8_t>(std::lround(200.0 * (1.0 - std::abs(core.distance) / most)));
    return core.distance > 0.0 ? std::array<std::uint8_t, 3>{220, pale, pale} : std::array<std::uint8_t, 3>{pale, pale, 220};
}

/// What follows a point in either format.
void appendMeasures(Bytes& bytes, const CoreDistance& core) {
    append(bytes, core.distance);
    append(bytes, core.detection);
    append(bytes, static_cast<float>(core.first.roughness));
    append(bytes, static_cast<float>(core.second.roughness));
    append(bytes, core.first.points);
    append(bytes, core.second.points);
    append(bytes, significance(core));
}

struct Measure {
    const char* name;
    std::uint8_t type;  ///< of LAS
    const char* ofPly;
};
constexpr std::array<Measure, 7> measures{{{"distance", 10, "double"},
                                           {"level_of_detection", 10, "double"},
                                           {"roughness_first", 9, "float"},
                                           {"roughness_second", 9, "float"},
                                           {"points_first", 5, "uint"},
                                           {"points_second", 5, "uint"},
                                           {"significant", 1, "uchar"}}};
constexpr std::uint16_t measureBytes = 33;

Bytes plyHead(const CloudComparison& made) {
    std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(made.cores.size()) +
                       "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\nproperty uchar green\n"
                       "property uchar blue\n";
    for (const Measure& measure : measures) {
        text += std::string("property ") + measure.ofPly + " " + measure.name + "\n";
    }
    text += "end_header\n";
    return Bytes(text.begin(), text.end());
}

/// The system of the first cloud as WKT; empty: it names none, or its numbers were brought to other units.
std::string systemOf(const CloudComparison& made) {
    const CloudUnits& units = made.first.head.units;
    const bool changed = made.unit == 1.0 && (units.metres != 1.0 || units.heightMetres != 1.0);
    const GdalSession session;
    OGRSpatialReference system;
    if (changed || !setFromText(system, made.first.head.crs)) {
        return "";
    }
    char* text = nullptr;
    std::string wkt;
    if (system.exportToWkt(&text) == OGRERR_NONE) {
        wkt = text;
    }
    CPLFree(text);
    return wkt;
}

void appendRecord(Bytes& bytes, std::string_view user, std::uint16_t id, const Bytes& content) {
    append(bytes, std::uint16_t{0});
    appendText(bytes, user, 16);
    append(bytes, id);
    append(bytes, static_cast<std::uint16_t>(content.size()));
    appendText(bytes, "", 32);
    bytes.insert(bytes.end(), content.begin(), content.end());
}

/// Core points as LAS 1.4.
class DistanceLas {
public:
    explicit DistanceLas(const CloudComparison& made) : m_made(made) {
        for (const Vec3& core : made.cores) {
            m_box.extend(core);
        }
        m_offset = m_box.min().array().floor();
        const Vec3 whole = (m_box.max() - m_offset) / 2e9;
        m_scale = Vec3::Constant(1e-4).cwiseMax(whole);
    }

    Bytes head() const {
        Bytes records;
        std::uint32_t count = 1;
        Bytes extra;
        for (const Measure& measure : measures) {
            append(extra, std::uint16_t{0});
            extra.push_back(measure.type);
            extra.push_back(0);
            appendText(extra, measure.name, 32);
            appendText(extra, "", 156);
        }
        appendRecord(records, "LASF_Spec", 4, extra);
        if (const std::string wkt = systemOf(m_made); !wkt.empty() && wkt.size() < 65'000) {
            Bytes text(wkt.begin(), wkt.end());
            text.push_back(0);
            appendRecord(records, "LASF_Projection", 2112, text);
            ++count;
        }
        Bytes bytes;
        appendText(bytes, "LASF", 4);
        append(bytes, std::uint16_t{0});
        append(bytes, std::uint16_t{16});  // the system is WKT
        appendText(bytes, "", 16);
        bytes.push_back(1);
        bytes.push_back(4);
        appendText(bytes, "Rubble", 32);
        appendText(bytes, "Rubble", 32);
        append(bytes, std::uint32_t{0});  // no date, so that equal work gives equal bytes
        append(bytes, std::uint16_t{375});
        append(bytes, static_cast<std::uint32_t>(375 + records.size()));
        append(bytes, count);
        bytes.push_back(7);
        append(bytes, static_cast<std::uint16_t>(36 + measureBytes));
        appendText(bytes, "", 24);  // the counts of older versions
        for (int axis = 0; axis < 3; ++axis) {
            append(bytes, m_scale[axis]);
        }
        for (int axis = 0; axis < 3; ++axis) {
            append(bytes, m_offset[axis]);
        }
        for (int axis = 0; axis < 3; ++axis) {
            append(bytes, m_box.max()[axis]);
            append(bytes, m_box.min()[axis]);
        }
        appendText(bytes, "", 20);
        append(bytes, static_cast<std::uint64_t>(m_made.cores.size()));
        append(bytes, static_cast<std::uint64_t>(m_made.cores.size()));  // all are of the first echo
        appendText(bytes, "", 14 * 8);
        bytes.insert(bytes.end(), records.begin(), records.end());
        return bytes;
    }

    void appendPoint(Bytes& bytes, std::size_t k, const std::array<std::uint8_t, 3>& colour) const {
        const Vec3 steps = (m_made.cores[k] - m_offset).cwiseQuotient(m_scale);
        for (int axis = 0; axis < 3; ++axis) {
            append(bytes, static_cast<std::int32_t>(std::llround(steps[axis])));
        }
        append(bytes, std::uint16_t{0});
        bytes.push_back(0x11);
        appendText(bytes, "", 7);
        append(bytes, 0.0);
        for (const std::uint8_t part : colour) {
            append(bytes, static_cast<std::uint16_t>(257 * part));
        }
    }

private:
    const CloudComparison& m_made;
    Aabb m_box;
    Vec3 m_offset;
    Vec3 m_scale;
};

}  // namespace

bool namesDistanceCloud(const std::string& path) {
    return hasEnding(path, ".las") || hasEnding(path, ".ply");
}

void writeDistanceCloud(const std::string& path, const CloudComparison& made) {
    const bool ply = hasEnding(path, ".ply");
    const double most = greatestSignificant(made);
    const DistanceLas las(made);
    writeAtomically(path, [&](std::ostream& out) {
        const auto put = [&](const Bytes& bytes) {
            out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        };
        put(ply ? plyHead(made) : las.head());
        Bytes bytes;
        for (std::size_t k = 0; k < made.cores.size(); ++k) {
            bytes.clear();
            const std::array<std::uint8_t, 3> colour = colourOf(made.distances[k], most);
            if (ply) {
                for (const double value : made.cores[k]) {
                    append(bytes, value);
                }
                bytes.insert(bytes.end(), colour.begin(), colour.end());
            } else {
                las.appendPoint(bytes, k, colour);
            }
            appendMeasures(bytes, made.distances[k]);
            put(bytes);
        }
    });
}

}  // namespace rubble::io
