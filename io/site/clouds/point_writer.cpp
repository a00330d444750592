#include "io/site/clouds/point_writer.h"

#include <ogr_spatialref.h>

#include <cmath>
#include <ostream>

#include "core/base/csv_text.h"
#include "io/base/files.h"
#include "io/site/gdal_session.h"
#include "io/site/system_way.h"

namespace rubble::io {

namespace {

/// A text in so many bytes, filled with zeros.
void appendText(FileBytes& bytes, std::string_view text, std::size_t length) {
    for (std::size_t k = 0; k < length; ++k) {
        bytes.push_back(k < text.size() ? static_cast<unsigned char>(text[k]) : 0);
    }
}

/// A system as WKT; empty: the text names none.
std::string wktOfText(const std::string& crs) {
    const GdalSession session;
    OGRSpatialReference system;
    if (!setFromText(system, crs)) {
        return "";
    }
    return wktOf(system);
}

FileBytes plyHead(const WrittenCloud& cloud) {
    std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(cloud.points) +
                       "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\nproperty uchar green\n"
                       "property uchar blue\n";
    const auto property = [&](const char* type, const char* name) { text += std::string("property ") + type + " " + name + "\n"; };
    if (cloud.classes) {
        property("uchar", "class");
    }
    if (!cloud.scanners.empty()) {
        property("ushort", "scan");
    }
    for (const WrittenColumn& column : cloud.columns) {
        property(column.ofPly, column.name);
    }
    for (const auto& [at, points] : cloud.scanners) {
        text += "comment scanner " + exactNumber(at.x()) + " " + exactNumber(at.y()) + " " + exactNumber(at.z()) + "\n";
    }
    if (cloud.instant) {
        text += "comment instant " + exactNumber(*cloud.instant) + "\n";
    }
    if (!cloud.run.empty()) {
        text += "comment run " + cloud.run + "\n";
    }
    text += "end_header\n";
    return FileBytes(text.begin(), text.end());
}

void appendPly(FileBytes& bytes, const WrittenCloud& cloud, const WrittenPoint& point) {
    for (const double value : point.place) {
        appendNumber(bytes, value);
    }
    bytes.insert(bytes.end(), point.colour.begin(), point.colour.end());
    if (cloud.classes) {
        bytes.push_back(point.kind);
    }
    if (!cloud.scanners.empty()) {
        appendNumber(bytes, point.scanner);
    }
}

void appendRecord(FileBytes& bytes, std::string_view user, std::uint16_t id, const FileBytes& content) {
    appendNumber(bytes, std::uint16_t{0});
    appendText(bytes, user, 16);
    appendNumber(bytes, id);
    appendNumber(bytes, static_cast<std::uint16_t>(content.size()));
    appendText(bytes, "", 32);
    bytes.insert(bytes.end(), content.begin(), content.end());
}

/// Points as LAS 1.4, format 7.
class LasWriting {
public:
    explicit LasWriting(const WrittenCloud& cloud) : m_cloud(cloud) {
        m_offset = cloud.box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(cloud.box.min().array().floor());
        const Vec3 whole = cloud.box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3((cloud.box.max() - m_offset) / 2e9);
        m_scale = Vec3::Constant(1e-4).cwiseMax(whole);
    }

    FileBytes head() const {
        std::uint32_t count = 0;
        const FileBytes records = recordsOf(count);
        std::uint16_t extra = 0;
        for (const WrittenColumn& column : m_cloud.columns) {
            extra = static_cast<std::uint16_t>(extra + column.bytes);
        }
        FileBytes bytes;
        appendText(bytes, "LASF", 4);
        appendNumber(bytes, std::uint16_t{0});
        appendNumber(bytes, std::uint16_t{16});  // the system is WKT
        appendText(bytes, "", 16);
        bytes.push_back(1);
        bytes.push_back(4);
        appendText(bytes, writingProgram, 32);
        appendText(bytes, writingProgram, 32);
        appendNumber(bytes, std::uint32_t{0});  // no date, so that equal work gives equal bytes
        appendNumber(bytes, std::uint16_t{375});
        appendNumber(bytes, static_cast<std::uint32_t>(375 + records.size()));
        appendNumber(bytes, count);
        bytes.push_back(7);
        appendNumber(bytes, static_cast<std::uint16_t>(36 + extra));
        appendText(bytes, "", 24);  // the counts of older versions
        const Vec3 high = m_cloud.box.isEmpty() ? m_offset : Vec3(m_cloud.box.max());
        const Vec3 low = m_cloud.box.isEmpty() ? m_offset : Vec3(m_cloud.box.min());
        for (int axis = 0; axis < 3; ++axis) {
            appendNumber(bytes, m_scale[axis]);
        }
        for (int axis = 0; axis < 3; ++axis) {
            appendNumber(bytes, m_offset[axis]);
        }
        for (int axis = 0; axis < 3; ++axis) {
            appendNumber(bytes, high[axis]);
            appendNumber(bytes, low[axis]);
        }
        appendText(bytes, "", 20);
        appendNumber(bytes, m_cloud.points);
        appendNumber(bytes, m_cloud.points);  // all are of the first echo
        appendText(bytes, "", 14 * 8);
        bytes.insert(bytes.end(), records.begin(), records.end());
        return bytes;
    }

    void appendPoint(FileBytes& bytes, const WrittenPoint& point) const {
        const Vec3 steps = (point.place - m_offset).cwiseQuotient(m_scale);
        for (int axis = 0; axis < 3; ++axis) {
            appendNumber(bytes, static_cast<std::int32_t>(std::llround(steps[axis])));
        }
        appendNumber(bytes, std::uint16_t{0});
        bytes.push_back(0x11);
        bytes.push_back(0);
        bytes.push_back(point.kind);
        appendText(bytes, "", 3);
        appendNumber(bytes, static_cast<std::uint16_t>(m_cloud.scanners.empty() ? 0 : point.scanner + 1));
        appendNumber(bytes, 0.0);
        for (const std::uint8_t part : point.colour) {
            appendNumber(bytes, static_cast<std::uint16_t>(257 * part));
        }
    }

private:
    FileBytes recordsOf(std::uint32_t& count) const {
        FileBytes records;
        const auto add = [&](std::string_view user, std::uint16_t id, const FileBytes& content) {
            appendRecord(records, user, id, content);
            ++count;
        };
        if (!m_cloud.columns.empty()) {
            FileBytes extra;
            for (const WrittenColumn& column : m_cloud.columns) {
                appendNumber(extra, std::uint16_t{0});
                extra.push_back(column.ofLas);
                extra.push_back(0);
                appendText(extra, column.name, 32);
                appendText(extra, "", 156);
            }
            add("LASF_Spec", 4, extra);
        }
        if (const std::string wkt = wktOfText(m_cloud.crs); !wkt.empty() && wkt.size() < 65'000) {
            FileBytes text(wkt.begin(), wkt.end());
            text.push_back(0);
            add("LASF_Projection", 2112, text);
        }
        if (!m_cloud.scanners.empty()) {
            FileBytes places;
            for (const auto& [at, points] : m_cloud.scanners) {
                for (const double value : at) {
                    appendNumber(places, value);
                }
                appendNumber(places, points);
            }
            add(scannerUser, scannerRecord, places);
        }
        if (m_cloud.instant) {
            FileBytes seconds;
            appendNumber(seconds, *m_cloud.instant);
            add(scannerUser, instantRecord, seconds);
        }
        if (!m_cloud.run.empty()) {
            add(scannerUser, runRecord, FileBytes(m_cloud.run.begin(), m_cloud.run.end()));
        }
        return records;
    }

    const WrittenCloud& m_cloud;
    Vec3 m_offset;
    Vec3 m_scale;
};

}  // namespace

bool namesWrittenCloud(const std::string& path) {
    return hasEnding(path, ".las") || hasEnding(path, ".ply");
}

void writePoints(const std::string& path, const WrittenCloud& cloud, const std::function<void(std::size_t, WrittenPoint&)>& fill) {
    const bool ply = hasEnding(path, ".ply");
    const LasWriting las(cloud);
    writeAtomically(path, [&](std::ostream& out) {
        const auto put = [&](const FileBytes& bytes) {
            out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        };
        put(ply ? plyHead(cloud) : las.head());
        FileBytes bytes;
        WrittenPoint point;
        for (std::size_t k = 0; k < cloud.points; ++k) {
            bytes.clear();
            point.more.clear();
            fill(k, point);
            if (ply) {
                appendPly(bytes, cloud, point);
            } else {
                las.appendPoint(bytes, point);
            }
            bytes.insert(bytes.end(), point.more.begin(), point.more.end());
            put(bytes);
        }
    });
}

}  // namespace rubble::io
