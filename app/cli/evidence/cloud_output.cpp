#include "app/cli/evidence/cloud_output.h"

#include <array>
#include <charconv>
#include <cmath>

#include "app/cli/frame/text_output.h"
#include "core/base/message.h"

namespace rubble::cli {

namespace {

std::string countText(std::uint64_t number) {
    return englishInteger(static_cast<std::int64_t>(number));
}

Json vectorJson(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

Json boxJson(const Aabb& box) {
    return box.isEmpty() ? Json() : Json{{"min", vectorJson(box.min())}, {"max", vectorJson(box.max())}};
}

/// Names of the fates of points that are left out, with the keys of the manual.
constexpr std::array<std::pair<io::PointFate, const char*>, 5> leftOut{{{io::PointFate::Invalid, "invalid"},
                                                                        {io::PointFate::Withheld, "withheld"},
                                                                        {io::PointFate::Noise, "noise"},
                                                                        {io::PointFate::NoReturn, "no_return"},
                                                                        {io::PointFate::NotFinite, "not_finite"}}};

std::uint64_t countOf(const io::CloudSummary& summary, io::PointFate fate) {
    return summary.fates[static_cast<std::size_t>(fate)];
}

Json poseJson(const io::CloudPose& pose, bool known) {
    if (!known) {
        return {};
    }
    const Quat& turn = pose.orientation;
    return {{"position", vectorJson(pose.position)},
            {"rotation_wxyz", {turn.w(), turn.x(), turn.y(), turn.z()}},
            {"applied", pose.applied}};
}

Json unitsJson(const io::CloudUnits& units) {
    Json object;
    object["system"] = units.local() ? Json() : Json(units.name);
    object["height_system"] = units.heightSystem.empty() ? Json() : Json(units.heightSystem);
    object["degrees"] = units.degrees;
    object["geocentric"] = units.geocentric;
    object["metres"] = units.degrees ? Json() : Json(units.metres);
    object["metres_stated"] = units.metresStated;
    object["height_metres"] = units.heightMetres;
    object["height_metres_stated"] = units.heightStated;
    return object;
}

/// [{id, points}] of a table of counts.
template <class Key>
Json countsJson(const std::map<Key, std::uint64_t>& counts, const char* key) {
    Json rows = Json::array();
    for (const auto& [value, points] : counts) {
        rows.push_back({{key, int{value}}, {"points", points}});
    }
    return rows;
}

Json scansJson(const io::CloudHead& head, const io::CloudSummary& summary) {
    Json rows = Json::array();
    for (std::size_t s = 0; s < head.scans.size(); ++s) {
        const io::CloudScan& scan = head.scans[s];
        rows.push_back({{"name", scan.name},
                        {"points", summary.scans[s]},
                        {"points_promised", scan.promised},
                        {"pose", poseJson(scan.pose, summary.posed[s])}});
    }
    return rows;
}

Json photographsJson(const io::CloudHead& head, const std::vector<std::string>& paths) {
    Json rows = Json::array();
    for (std::size_t p = 0; p < head.photographs.size(); ++p) {
        const io::CloudPhotograph& photograph = head.photographs[p];
        const bool lens = photograph.focal > 0.0;
        rows.push_back({{"name", photograph.name},
                        {"projection", photograph.projection},
                        {"kind", photograph.kind},
                        {"bytes", photograph.bytes},
                        {"width_px", photograph.width},
                        {"height_px", photograph.height},
                        {"focal_px", lens ? Json(photograph.focal) : Json()},
                        {"principal_px", lens ? Json{photograph.principal.x(), photograph.principal.y()} : Json()},
                        {"pose", poseJson(photograph.pose, photograph.pose.stated)},
                        {"file", p < paths.size() ? Json(paths[p]) : Json()}});
    }
    return rows;
}

/// Twelve digits: a hundredth of a millimetre at ten thousand kilometres, without the noise of doubles.
std::string coordinateText(double value) {
    std::array<char, 32> text{};
    const std::to_chars_result end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 12);
    return std::string(text.data(), end.ptr);
}

std::string boxText(const Aabb& box, const std::string& unit) {
    const auto range = [&](const char* axis, int k) {
        return std::string(axis) + " " + coordinateText(box.min()[k]) + " to " + coordinateText(box.max()[k]);
    };
    return range("x", 0) + ", " + range("y", 1) + ", " + range("z", 2) + unit;
}

std::string unitText(double metres, bool stated) {
    const std::string one = metres == 1.0 ? "metres" : exactNumber(metres) + " m each";
    return one + (stated ? "" : " (assumed)");
}

std::string unitsText(const io::CloudUnits& units) {
    const std::string height = "z: " + unitText(units.heightMetres, units.heightStated);
    return (units.degrees ? "x, y: degrees; " : "x, y: " + unitText(units.metres, units.metresStated) + "; ") + height;
}

std::string poseText(const io::CloudPose& pose, bool known) {
    if (!known) {
        return "no pose";
    }
    const Eigen::AngleAxisd turn(pose.orientation);
    return "at " + coordinateText(pose.position.x()) + ", " + coordinateText(pose.position.y()) + ", " +
           coordinateText(pose.position.z()) + ", turned by " + englishNumber(turn.angle() * 180.0 / M_PI) + " degrees" +
           (pose.applied ? "" : ", not applied");
}

template <class Key>
std::string countsText(const std::map<Key, std::uint64_t>& counts) {
    std::string text;
    for (const auto& [value, points] : counts) {
        text += (text.empty() ? "" : ", ") + std::to_string(int{value}) + ": " + countText(points);
    }
    return text;
}

void addColumns(FactList& facts, const io::CloudHead& head, const io::CloudSummary& summary) {
    if (head.columns.intensity) {
        facts.add("intensities", englishNumber(summary.intensityLeast) + " to " + englishNumber(summary.intensityMost));
    }
    if (head.columns.colour) {
        facts.add("colours", "up to " + std::to_string(summary.colourMost) + " of " + englishNumber(head.fullColour));
    }
    if (head.columns.classes) {
        facts.add("classes", countsText(summary.classes));
    }
    if (head.columns.returns) {
        facts.add("returns", countsText(summary.returns));
    }
    std::string unread;
    for (const std::string& name : head.unread) {
        unread += (unread.empty() ? "" : ", ") + name;
    }
    if (!unread.empty()) {
        facts.add("not read", unread);
    }
}

void printScans(std::ostream& out, const io::CloudHead& head, const io::CloudSummary& summary) {
    if (!head.scans.empty()) {
        printHeading(out, "Scans");
    }
    for (std::size_t s = 0; s < head.scans.size(); ++s) {
        const io::CloudScan& scan = head.scans[s];
        out << "  " << (scan.name.empty() ? "unnamed" : scan.name) << ": " << countText(summary.scans[s]) << " of "
            << countText(scan.promised) << " points, " << poseText(scan.pose, summary.posed[s]) << '\n';
    }
    if (!head.photographs.empty()) {
        printHeading(out, "Photographs in the file");
    }
    for (const io::CloudPhotograph& photograph : head.photographs) {
        out << "  " << (photograph.name.empty() ? "unnamed" : photograph.name) << ": " << photograph.projection << ", "
            << photograph.width << " x " << photograph.height << " pixels, " << photograph.kind << ", "
            << poseText(photograph.pose, photograph.pose.stated) << '\n';
    }
}

}  // namespace

Json cloudJson(const io::PointCloud& cloud, const io::CloudSummary& summary, const std::vector<std::string>& photographs) {
    const io::CloudHead& head = cloud.head();
    Json object;
    object["path"] = cloud.path();
    object["format"] = head.format;
    object["version"] = head.version.empty() ? Json() : Json(head.version);
    object["coding"] = head.coding;
    object["points_promised"] = head.promised ? Json(*head.promised) : Json();
    object["points"] = summary.points();
    Json left;
    for (const auto& [fate, key] : leftOut) {
        left[key] = countOf(summary, fate);
    }
    object["left_out"] = std::move(left);
    object["bounds"] = boxJson(summary.bounds);
    object["bounds_m"] = boxJson(summary.metres);
    object["scale"] = head.scale ? vectorJson(*head.scale) : Json();
    object["offset"] = head.offset ? vectorJson(*head.offset) : Json();
    object["crs"] = head.crs;
    object["crs_from"] = head.crsFrom;
    object["units"] = unitsJson(head.units);
    object["intensity"] =
        head.columns.intensity ? Json{{"least", summary.intensityLeast}, {"most", summary.intensityMost}} : Json();
    object["colour"] = head.columns.colour ? Json{{"most", summary.colourMost}, {"full", head.fullColour}} : Json();
    object["classes"] = countsJson(summary.classes, "class");
    object["returns"] = countsJson(summary.returns, "return");
    object["has_times"] = head.columns.times;
    object["scans"] = scansJson(head, summary);
    object["instant_s"] = head.instant ? Json(*head.instant) : Json();
    object["photographs"] = photographsJson(head, photographs);
    object["not_read"] = head.unread;
    object["warnings"] = findingsJson(summary.findings);
    return object;
}

void printCloud(std::ostream& out, const io::PointCloud& cloud, const io::CloudSummary& summary) {
    const io::CloudHead& head = cloud.head();
    out << cloud.path() << '\n';
    FactList facts;
    facts.add("format",
              head.format + (head.version.empty() ? "" : " " + head.version) + (head.coding.empty() ? "" : ", " + head.coding));
    std::string left;
    for (const auto& [fate, key] : leftOut) {
        if (const std::uint64_t count = countOf(summary, fate); count > 0) {
            left += (left.empty() ? "; left out: " : ", ") + std::string(key) + " " + countText(count);
        }
    }
    facts.add("points", countText(summary.points()) + left);
    facts.add("system", head.units.local() ? "none named" : head.units.name + " (" + head.crsFrom + ")");
    if (!head.units.local()) {
        facts.add("heights", head.units.heightSystem.empty() ? "from a datum that is not named" : head.units.heightSystem);
    }
    facts.add("units", unitsText(head.units));
    if (!summary.bounds.isEmpty()) {
        facts.add("bounds", boxText(summary.bounds, ""));
        facts.add("bounds in metres", summary.metres.isEmpty() ? "none: x and y are degrees" : boxText(summary.metres, " m"));
    }
    if (head.scale) {
        facts.add("scale",
                  exactNumber(head.scale->x()) + ", " + exactNumber(head.scale->y()) + ", " + exactNumber(head.scale->z()));
        facts.add("offset",
                  exactNumber(head.offset->x()) + ", " + exactNumber(head.offset->y()) + ", " + exactNumber(head.offset->z()));
    }
    addColumns(facts, head, summary);
    facts.print(out);
    printScans(out, head, summary);
    printFindings(out, summary.findings);
}

Json octreeJson(const io::OpenedOctree& index, double seconds) {
    const io::CloudOctree& octree = *index.octree;
    return {{"path", octree.path()},
            {"made", index.made},
            {"points", octree.head().points},
            {"nodes", octree.nodes().size()},
            {"levels", octree.levels()},
            {"coarsest_spacing_m", octree.nodes().front().spacing},
            {"bytes", octree.bytes()},
            {"place_step_m", octree.placeStep()},
            {"far_points", octree.head().farPoints},
            {"far_place_step_m", octree.head().farPoints > 0 ? Json(octree.farPlaceStep()) : Json()},
            {"seconds", seconds}};
}

void printOctree(std::ostream& out, const io::OpenedOctree& index, double seconds) {
    const io::CloudOctree& octree = *index.octree;
    printHeading(out, "Octree");
    FactList facts;
    facts.add("file", octree.path());
    facts.add("state", std::string(index.made ? "made" : "kept from before, opened") + " in " + englishNumber(seconds) + " s");
    facts.add("points", countText(octree.head().points) + " in " + countText(octree.nodes().size()) + " nodes of " +
                            std::to_string(octree.levels()) + " levels");
    facts.add("spacing", englishNumber(octree.nodes().front().spacing) + " m on the coarsest level, halved from each to the next");
    facts.add("places", "kept to " + englishNumber(octree.placeStep()) + " m");
    if (octree.head().farPoints > 0) {
        facts.add("far points",
                  countText(octree.head().farPoints) +
                      " lie more than 8 widths of the bulk of the others, or 100 km, away; in levels of their own, kept to " +
                      englishNumber(octree.farPlaceStep()) + " m, and not drawn in views unless they are what is looked at");
    }
    facts.add("size", countText(octree.bytes()) + " bytes");
    facts.print(out);
}

}  // namespace rubble::cli
