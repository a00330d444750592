#include "tests/io/site/clouds/made_clouds.h"

#include <algorithm>
#include <limits>
#include "io/site/clouds/e57/e57_source.h"
#include "tests/support/places.h"

namespace rubble::io {

namespace {

void putRecord(CloudBytes& bytes, std::size_t at, const LasLayout& layout, const MadePoint& point) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        putNumber(bytes, at + 4 * axis, point.place[axis]);
    }
    putNumber(bytes, at + 12, point.intensity);
    if (layout.wide) {
        bytes[at + 14] = static_cast<unsigned char>(point.echo | point.echoes << 4);
        bytes[at + 15] = point.withheld ? 4 : 0;
        bytes[at + 16] = point.kind;
    } else {
        bytes[at + 14] = static_cast<unsigned char>(point.echo | point.echoes << 3);
        bytes[at + 15] = static_cast<unsigned char>(point.kind | (point.withheld ? 128 : 0));
    }
    if (layout.time >= 0) {
        putNumber(bytes, at + static_cast<std::size_t>(layout.time), point.time);
    }
    if (layout.colour >= 0) {
        putNumber(bytes, at + static_cast<std::size_t>(layout.colour), point.colour);
    }
}

}  // namespace

CloudBytes MadeLas::bytes() const {
    const LasLayout layout = *lasLayout(format);
    const std::size_t headBytes = minor < 3 ? 227 : minor == 3 ? 235 : 375;
    const std::size_t start = headBytes + (wkt.empty() ? 0 : 54 + wkt.size() + 1);
    const std::size_t step = layout.bytes + extra;
    CloudBytes bytes(start + step * points.size());
    std::copy_n("LASF", 4, bytes.begin());
    bytes[6] = wkt.empty() ? 0 : 16;
    bytes[24] = 1;
    bytes[25] = static_cast<unsigned char>(minor);
    putNumber(bytes, 94, static_cast<std::uint16_t>(headBytes));
    putNumber(bytes, 96, static_cast<std::uint32_t>(start));
    putNumber(bytes, 100, std::uint32_t{wkt.empty() ? 0U : 1U});
    bytes[104] = static_cast<unsigned char>(format);
    putNumber(bytes, 105, static_cast<std::uint16_t>(step));
    putNumber(bytes, 107, minor < 4 ? static_cast<std::uint32_t>(points.size()) : 0U);
    if (minor >= 4) {
        putNumber(bytes, 247, static_cast<std::uint64_t>(points.size()));
    }
    Aabb box;
    for (std::size_t p = 0; p < points.size(); ++p) {
        putRecord(bytes, start + step * p, layout, points[p]);
        const auto& place = points[p].place;
        box.extend(Vec3(place[0], place[1], place[2]).cwiseProduct(scale) + offset);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        putNumber(bytes, 131 + 8 * at, scale[axis]);
        putNumber(bytes, 155 + 8 * at, offset[axis]);
        putNumber(bytes, 179 + 16 * at, points.empty() ? 0.0 : box.max()[axis]);
        putNumber(bytes, 187 + 16 * at, points.empty() ? 0.0 : box.min()[axis]);
    }
    if (!wkt.empty()) {
        std::copy_n("LASF_Projection", 15, bytes.begin() + static_cast<std::ptrdiff_t>(headBytes) + 2);
        putNumber(bytes, headBytes + 18, std::uint16_t{2112});
        putNumber(bytes, headBytes + 20, static_cast<std::uint16_t>(wkt.size() + 1));
        std::copy(wkt.begin(), wkt.end(), bytes.begin() + static_cast<std::ptrdiff_t>(headBytes) + 54);
    }
    return bytes;
}

std::uint64_t MadeE57::addPoints(const std::vector<Column>& columns, std::size_t packetPoints) {
    m_content.resize((m_content.size() + 3) / 4 * 4);
    const std::size_t section = m_content.size();
    m_content.resize(section + 32);
    m_content[section] = 1;
    putNumber(m_content, section + 16, placeInFile(section + 32));
    const std::size_t points = columns.front().raw.size();
    std::vector<CloudBytes> streams;
    for (const Column& column : columns) {
        CloudBytes stream((points * column.bits + 7) / 8);
        for (std::size_t p = 0; p < points; ++p) {
            for (std::uint32_t b = 0; b < column.bits; ++b) {
                const std::size_t bit = p * column.bits + b;
                stream[bit / 8] = static_cast<unsigned char>(stream[bit / 8] | (column.raw[p] >> b & 1) << bit % 8);
            }
        }
        streams.push_back(std::move(stream));
    }
    // Packets cut the streams where they like, in the middle of a value too.
    for (std::size_t first = 0; first < points; first += packetPoints) {
        CloudBytes packet{1, 0, 0, 0};
        putNumber(packet, 4, static_cast<std::uint16_t>(columns.size()));
        CloudBytes data;
        for (std::size_t c = 0; c < columns.size(); ++c) {
            const auto cut = [&](std::size_t point) {
                const bool last = point >= points;
                return static_cast<std::ptrdiff_t>(last ? streams[c].size() : point * columns[c].bits / 8);
            };
            const std::ptrdiff_t from = cut(first);
            const std::ptrdiff_t to = cut(first + packetPoints);
            putNumber(packet, packet.size(), static_cast<std::uint16_t>(to - from));
            data.insert(data.end(), streams[c].begin() + from, streams[c].begin() + to);
        }
        packet.insert(packet.end(), data.begin(), data.end());
        packet.resize((packet.size() + 3) / 4 * 4);
        putNumber(packet, 2, static_cast<std::uint16_t>(packet.size() - 1));
        m_content.insert(m_content.end(), packet.begin(), packet.end());
    }
    putNumber(m_content, section + 8, static_cast<std::uint64_t>(m_content.size() - section));
    return placeInFile(section);
}

std::uint64_t MadeE57::addBlob(const std::string& picture) {
    m_content.resize((m_content.size() + 3) / 4 * 4);
    const std::size_t section = m_content.size();
    m_content.resize(section + 16);
    m_content.insert(m_content.end(), picture.begin(), picture.end());
    return placeInFile(section);
}

CloudBytes MadeE57::bytes(const std::string& xml) const {
    CloudBytes all = m_content;
    const std::size_t start = (all.size() + 3) / 4 * 4;
    all.resize(start);
    all.insert(all.end(), xml.begin(), xml.end());
    const std::size_t pages = (all.size() + content - 1) / content;
    all.resize(pages * content);
    std::copy_n("ASTM-E57", 8, all.begin());
    putNumber(all, 8, std::uint32_t{1});
    putNumber(all, 16, static_cast<std::uint64_t>(pages * 1024));
    putNumber(all, 24, placeInFile(start));
    putNumber(all, 32, static_cast<std::uint64_t>(xml.size()));
    putNumber(all, 40, std::uint64_t{1024});
    CloudBytes file;
    for (std::size_t page = 0; page < pages; ++page) {
        const unsigned char* from = &all[page * content];
        file.insert(file.end(), from, from + content);
        const std::uint32_t sum = crc32c(from, content);
        for (int shift = 24; shift >= 0; shift -= 8) {
            file.push_back(static_cast<unsigned char>(sum >> shift));
        }
    }
    return file;
}

CloudBytes cloudWithPictures(const std::string& width, std::size_t which, const std::string& pixelHeight) {
    const std::string tiny = sourcePath("tests/data/clouds/tiny_pc_and_images.e57");
    const CloudBytes png = photographOfE57(tiny, openCloud(tiny)->head().photographs[which]);
    MadeE57 made;
    const std::uint64_t points = made.addPoints({{8, {1}}, {8, {2}}, {8, {3}}}, 1);
    const std::uint64_t picture = made.addBlob(std::string(png.begin(), png.end()));
    std::string fields;
    for (const char* axis : {"X", "Y", "Z"}) {
        fields += "<cartesian" + std::string(axis) + " type=\"Integer\" minimum=\"0\" maximum=\"255\"/>";
    }
    const std::string pinhole = "<pinholeRepresentation type=\"Structure\"><pngImage type=\"Blob\" fileOffset=\"" +
                                std::to_string(picture) + "\" length=\"" + std::to_string(png.size()) +
                                "\"/><imageWidth type=\"Integer\">" + width +
                                "</imageWidth><imageHeight type=\"Integer\">100</imageHeight>"
                                "<focalLength type=\"Float\">0.02</focalLength><pixelWidth type=\"Float\">0.0001</pixelWidth>"
                                "<pixelHeight type=\"Float\">" +
                                pixelHeight +
                                "</pixelHeight><principalPointX type=\"Float\">48</principalPointX>"
                                "<principalPointY type=\"Float\">53</principalPointY></pinholeRepresentation>";
    const std::string pose =
        "<pose type=\"Structure\"><translation type=\"Structure\"><x type=\"Float\">10</x><y type=\"Float\">20</y>"
        "<z type=\"Float\">50</z></translation></pose>";
    return made.bytes(
        "<?xml version=\"1.0\"?><e57Root type=\"Structure\"><data3D type=\"Vector\"><vectorChild type=\"Structure\">"
        "<points type=\"CompressedVector\" fileOffset=\"" +
        std::to_string(points) + "\" recordCount=\"1\"><prototype type=\"Structure\">" + fields +
        "</prototype></points></vectorChild></data3D><images2D type=\"Vector\"><vectorChild type=\"Structure\">"
        "<name type=\"String\">from above</name>" +
        pose + pinhole + "</vectorChild><vectorChild type=\"Structure\">" + pinhole + "</vectorChild></images2D></e57Root>");
}

}  // namespace rubble::io
