#include "io/site/clouds/e57/e57_head.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <pugixml.hpp>

#include "io/base/file_words.h"
#include "io/base/trimmed.h"

namespace rubble::io {

namespace {

template <class Number>
Number numberOf(std::string_view text, Number otherwise) {
    text = trimmed(text);
    if (text.starts_with('+')) {
        text.remove_prefix(1);
    }
    Number number{};
    const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
    return end.ec == std::errc{} ? number : otherwise;
}

/// A number in an element; an empty one is 0, as the standard has it. A scaled number lies as a whole one.
double realIn(const pugi::xml_node& node) {
    const double raw = numberOf<double>(node.child_value(), 0.0);
    const bool scaled = std::string_view(node.attribute("type").value()) == "ScaledInteger";
    return scaled ? raw * numberOf<double>(node.attribute("scale").value(), 1.0) +
                        numberOf<double>(node.attribute("offset").value(), 0.0)
                  : raw;
}

std::string textIn(const pugi::xml_node& node) {
    return std::string(trimmed(node.child_value()));
}

class E57Reading {
public:
    E57Reading(E57Pages& pages, Findings& findings) : m_pages(pages), m_findings(findings) {}

    E57Head read() {
        const std::vector<unsigned char> xml = m_pages.bytes(m_pages.xmlStart(), m_pages.xmlBytes());
        pugi::xml_document document;
        const pugi::xml_parse_result parsed = document.load_buffer(xml.data(), xml.size());
        const pugi::xml_node root = document.child("e57Root");
        if (!parsed || !root) {
            refuse("its XML ends at byte " + std::to_string(parsed.offset) + " or is none of an E57");
        }
        m_head.crs = textIn(root.child("coordinateMetadata"));
        for (const pugi::xml_node& scan : root.child("data3D").children("vectorChild")) {
            addScan(scan);
        }
        for (const pugi::xml_node& picture : root.child("images2D").children("vectorChild")) {
            addPhotograph(picture);
        }
        return std::move(m_head);
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        refuseContent({"cloud.e57_xml", "{0} cannot be read: {1}", {m_pages.path(), what}},
                      "Copy it again from where it came, or export the scans anew.");
    }

    CloudPose poseIn(const pugi::xml_node& node) {
        CloudPose pose;
        pose.stated = static_cast<bool>(node);
        const pugi::xml_node turn = node.child("rotation");
        const pugi::xml_node shift = node.child("translation");
        if (turn) {
            const Quat read(realIn(turn.child("w")), realIn(turn.child("x")), realIn(turn.child("y")), realIn(turn.child("z")));
            constexpr double unitError = 1e-3;
            const double length = read.norm();
            if (!(std::abs(length - 1.0) < unitError)) {
                addFinding(
                    m_findings, m_pages.path(),
                    {"cloud.pose_no_rotation", "the rotation of a pose is no rotation; it was brought to one, or left out", {}},
                    "compare the scans where they overlap, and export them anew");
            }
            pose.orientation = length > unitError && std::isfinite(length) ? read.normalized() : Quat::Identity();
        }
        pose.position = Vec3(realIn(shift.child("x")), realIn(shift.child("y")), realIn(shift.child("z")));
        if (!pose.position.allFinite()) {
            pose = CloudPose{};
        }
        return pose;
    }

    void addScan(const pugi::xml_node& node) {
        const pugi::xml_node points = node.child("points");
        CloudScan scan;
        scan.name = textIn(node.child("name"));
        scan.promised = points.attribute("recordCount").as_ullong();
        scan.pose = poseIn(node.child("pose"));
        scan.pose.applied = scan.pose.stated;
        E57Points read;
        read.start = m_pages.placeOf(points.attribute("fileOffset").as_ullong());
        read.records = scan.promised;
        for (const pugi::xml_node& field : points.child("prototype").children()) {
            read.fields.push_back(fieldIn(field));
        }
        const pugi::xml_node limits = node.child("colorLimits");
        read.colourLeast = realIn(limits.child("colorRedMinimum"));
        read.colourMost = realIn(limits.child("colorRedMaximum"));
        if (points.child("codecs").first_child()) {
            refuse("its points are packed by a codec of another program");
        }
        m_head.scans.push_back(std::move(scan));
        m_head.points.push_back(std::move(read));
    }

    E57Field fieldIn(const pugi::xml_node& node) const {
        E57Field field;
        field.name = node.name();
        const std::string_view type = node.attribute("type").value();
        if (type == "Float") {
            const bool single = std::string_view(node.attribute("precision").value()) == "single";
            field.kind = single ? E57Field::Kind::Single : E57Field::Kind::Double;
            field.bits = single ? 32 : 64;
            return field;
        }
        if (type == "String") {
            field.kind = E57Field::Kind::Text;
            field.bits = 0;
            return field;
        }
        if (type != "Integer" && type != "ScaledInteger") {
            refuse("its column " + field.name + " is of the kind \"" + std::string(type) + "\"");
        }
        using Limits = std::numeric_limits<std::int64_t>;
        field.kind = E57Field::Kind::Whole;
        field.least = numberOf<std::int64_t>(node.attribute("minimum").value(), Limits::min());
        const auto most = numberOf<std::int64_t>(node.attribute("maximum").value(), Limits::max());
        if (most < field.least) {
            refuse("its column " + field.name + " has no values between its limits");
        }
        field.bits =
            static_cast<std::uint32_t>(std::bit_width(static_cast<std::uint64_t>(most) - static_cast<std::uint64_t>(field.least)));
        field.scale = type == "Integer" ? 1.0 : numberOf<double>(node.attribute("scale").value(), 1.0);
        field.offset = type == "Integer" ? 0.0 : numberOf<double>(node.attribute("offset").value(), 0.0);
        return field;
    }

    /// Whether one focal length in pixels describes a pinhole. A height that the file leaves out is the width.
    bool squarePixels(double width, double height) {
        constexpr double alike = 1e-3;
        if (!(height > 0.0) || std::abs(height / width - 1.0) < alike) {
            return true;
        }
        addFinding(
            m_findings, m_pages.path(),
            {"cloud.pixels_not_square",
             "pictures have pixels of {0} by {1}: they are not taken as photographs with a known camera",
             {Argument(width, "m"), Argument(height, "m")}},
            "write them out with rubble-cli cloud --photographs, bring them to square pixels and place them by pairs of points");
        return false;
    }

    void addPhotograph(const pugi::xml_node& node) {
        constexpr std::pair<const char*, const char*> projections[] = {{"pinholeRepresentation", "pinhole"},
                                                                       {"sphericalRepresentation", "spherical"},
                                                                       {"cylindricalRepresentation", "cylindrical"},
                                                                       {"visualReferenceRepresentation", "visual reference"}};
        for (const auto& [element, words] : projections) {
            const pugi::xml_node shown = node.child(element);
            const bool jpeg = static_cast<bool>(shown.child("jpegImage"));
            const pugi::xml_node blob = shown.child(jpeg ? "jpegImage" : "pngImage");
            if (!blob) {
                continue;
            }
            CloudPhotograph photograph;
            photograph.name = textIn(node.child("name"));
            photograph.projection = words;
            photograph.kind = jpeg ? "jpeg" : "png";
            photograph.start = blob.attribute("fileOffset").as_ullong();
            photograph.bytes = blob.attribute("length").as_ullong();
            photograph.width = numberOf<std::int64_t>(shown.child("imageWidth").child_value(), 0);
            photograph.height = numberOf<std::int64_t>(shown.child("imageHeight").child_value(), 0);
            const double pixel = realIn(shown.child("pixelWidth"));
            const double focal = realIn(shown.child("focalLength"));
            if (focal > 0.0 && pixel > 0.0 && squarePixels(pixel, realIn(shown.child("pixelHeight")))) {
                photograph.focal = focal / pixel;
                photograph.principal = {realIn(shown.child("principalPointX")), realIn(shown.child("principalPointY"))};
            }
            photograph.pose = poseIn(node.child("pose"));
            m_head.photographs.push_back(std::move(photograph));
            return;
        }
    }

    E57Pages& m_pages;
    Findings& m_findings;
    E57Head m_head;
};

}  // namespace

E57Head readE57Head(E57Pages& pages, Findings& findings) {
    return E57Reading(pages, findings).read();
}

}  // namespace rubble::io
