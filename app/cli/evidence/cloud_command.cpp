#include <array>
#include <cctype>
#include <memory>
#include <vector>

#include "app/cli/evidence/cloud_distance_output.h"
#include "app/cli/evidence/cloud_output.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "core/base/csv_text.h"
#include "io/base/files.h"
#include "io/site/clouds/distance_files.h"

namespace rubble::cli {

namespace {

/// Writes points as a table, in the numbers of the file.
class PointTable {
public:
    PointTable(std::ostream& out, const io::CloudColumns& columns) : m_out(out) {
        out << "x,y,z";
        for (const auto& [there, names] : {std::pair(columns.intensity, ",intensity"), std::pair(columns.colour, ",red,green,blue"),
                                           std::pair(columns.classes, ",class"), std::pair(columns.returns, ",return,returns"),
                                           std::pair(columns.times, ",time"), std::pair(columns.scans, ",scan")}) {
            out << (there ? names : "");
        }
        out << '\n';
    }

    void add(const io::CloudBlock& block) {
        for (std::size_t i = 0; i < block.size(); ++i) {
            const Vec3& place = block.places[i];
            m_line = exactNumber(place.x()) + ',' + exactNumber(place.y()) + ',' + exactNumber(place.z());
            if (!block.intensity.empty()) {
                m_line += ',' + exactNumber(static_cast<double>(block.intensity[i]));
            }
            if (!block.colours.empty()) {
                for (const std::uint16_t step : block.colours[i]) {
                    addWhole(step);
                }
            }
            if (!block.classes.empty()) {
                addWhole(block.classes[i]);
            }
            if (!block.returns.empty()) {
                addWhole(block.returns[i]);
                addWhole(block.returnsOf[i]);
            }
            if (!block.times.empty()) {
                m_line += ',' + exactNumber(block.times[i]);
            }
            if (!block.scans.empty()) {
                addWhole(block.scans[i]);
            }
            m_out << m_line << '\n';
        }
    }

private:
    void addWhole(int number) { m_line += ',' + std::to_string(number); }

    std::ostream& m_out;
    std::string m_line;
};

io::CloudSummary readAll(const Arguments& arguments, io::PointCloud& cloud, const Execution& execution) {
    const auto path = arguments.value("--csv");
    if (!path) {
        return io::summariseCloud(cloud, execution);
    }
    io::CloudSummary summary;
    io::writeAtomically(*path, [&](std::ostream& out) {
        PointTable table(out, cloud.head().columns);
        summary = io::summariseCloud(cloud, execution, [&](const io::CloudBlock& block) { table.add(block); });
    });
    return summary;
}

/// Writes the pictures that lie in the cloud into the folder of --photographs. @return their paths; empty: none was asked for
std::vector<std::string> writePhotographs(const Arguments& arguments, const io::PointCloud& cloud) {
    std::vector<std::string> paths;
    const auto folder = arguments.value("--photographs");
    for (std::size_t p = 0; folder && p < cloud.head().photographs.size(); ++p) {
        const io::CloudPhotograph& photograph = cloud.head().photographs[p];
        std::string name = std::to_string(p + 1) + (photograph.name.empty() ? "" : "-");
        for (const char c : photograph.name.substr(0, 60)) {
            const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
            name += plain ? c : '_';
        }
        const std::vector<unsigned char> bytes = cloud.photograph(photograph);
        paths.push_back(*folder + "/" + name + "." + photograph.kind);
        io::writeIn(paths.back(), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    return paths;
}

io::CloudRequest cloudRequestFrom(const Arguments& arguments) {
    io::CloudRequest request;
    request.crs = arguments.value("--crs").value_or("");
    if (const auto columns = arguments.value("--columns")) {
        request.columns = splitAtCommas(*columns);
    }
    return request;
}

/// Options that ask for distances, and mean nothing without another cloud.
constexpr std::array<std::string_view, 7> distanceOptions{
    "--out", "--cores", "--normal-scale", "--projection-scale", "--depth", "--registration-error", "--metres"};

double scaleFrom(const Arguments& arguments, std::string_view option) {
    if (!arguments.has(option)) {
        throw UsageError({"cli.no_scale", "Distances between clouds need {0}", {std::string(option)}},
                         {"cli.no_scale.remedy",
                          "Give --normal-scale and --projection-scale several times the spacing of points, and --depth more than "
                          "the largest distance.",
                          {}});
    }
    return parseLength(arguments, option, 0.0);
}

ExitCode compareCloud(const Arguments& arguments, Session& session) {
    io::CloudComparisonRequest request;
    request.first = arguments.operand();
    request.second = *arguments.value("--against");
    request.cores = arguments.value("--cores").value_or("");
    request.read = cloudRequestFrom(arguments);
    request.metres = arguments.has("--metres");
    request.settings.normalRadius = scaleFrom(arguments, "--normal-scale");
    request.settings.projectionRadius = scaleFrom(arguments, "--projection-scale");
    request.settings.depth = scaleFrom(arguments, "--depth");
    if (arguments.has("--registration-error")) {
        request.settings.registrationError = parseLength(arguments, "--registration-error", 0.0, true);
    }
    const std::vector<std::string> inputs{request.first, request.second, request.cores.empty() ? request.first : request.cores};
    checkCsvPath(arguments, inputs);
    const std::vector<std::string> files = arguments.values("--out");
    for (const std::string& path : files) {
        if (!io::namesDistanceCloud(path)) {
            throw wrongValue("--out", path, "a path that ends in .las or .ply");
        }
        checkOutputPath(path, inputs);
    }
    const io::CloudComparison made = io::compareClouds(request, session.execution());
    if (const auto path = arguments.value("--csv")) {
        io::writeAtomically(*path, [&](std::ostream& out) { writeDistances(out, made); });
    }
    for (const std::string& path : files) {
        io::writeDistanceCloud(path, made);
    }
    if (arguments.json()) {
        printJson(session, cloudDistanceJson(made, request));
    } else {
        printCloudDistance(session.out(), made, request);
    }
    return ExitCode::Ok;
}

ExitCode tellCloud(const Arguments& arguments, Session& session) {
    if (arguments.has("--against")) {
        return compareCloud(arguments, session);
    }
    for (const std::string_view option : distanceOptions) {
        if (arguments.has(option)) {
            throw UsageError({"cli.needs_against", "{0} needs a second cloud", {std::string(option)}},
                             {"cli.needs_against.remedy", "Give it with --against.", {}});
        }
    }
    const std::vector<std::string> inputs{arguments.operand()};
    checkCsvPath(arguments, inputs);
    const io::CloudRequest request = cloudRequestFrom(arguments);
    const std::unique_ptr<io::PointCloud> cloud = io::openCloud(arguments.operand(), request);
    const io::CloudSummary summary = readAll(arguments, *cloud, session.execution());
    const std::vector<std::string> photographs = writePhotographs(arguments, *cloud);
    if (arguments.json()) {
        printJson(session, cloudJson(*cloud, summary, photographs));
    } else {
        printCloud(session.out(), *cloud, summary);
    }
    return ExitCode::Ok;
}

}  // namespace

Command cloudCommand() {
    return {
        "cloud",
        "FILE",
        "what is in a point cloud of a laser scanner or of photographs",
        "Reads every point of a LAS, LAZ, E57, PLY, PCD, PTX, PTS or table of text, and tells format, points, bounds in the "
        "numbers of the file and in metres, system, units, classes and scans, and what was left out and why. With --against it "
        "measures the distance to another cloud, with roughness and level of detection at 95 %.",
        {{"--crs", "SYSTEM", false, "coordinate system of a cloud that names none: EPSG code, WKT or PROJ"},
         {"--columns", "LIST", false, "columns of a table without a heading, such as x,y,z,intensity,red,green,blue,class,skip"},
         {"--photographs", "FOLDER", false, "write the pictures that lie in an E57"},
         {"--against", "CLOUD", false, "measure the distance from FILE to this cloud along the local normal (M3C2)"},
         {"--cores", "CLOUD", false,
          "points to measure at (default: those of FILE, one to each cube as wide as the projection scale)"},
         {"--normal-scale", "R", false, "radius about a core within which points of FILE give the normal"},
         {"--projection-scale", "R", false, "radius of the cylinder along the normal in which both clouds are averaged"},
         {"--depth", "D", false, "of the cylinder, to each side of the core"},
         {"--registration-error", "E", false, "by which one cloud may be out of place against the other (default: not known)"},
         {"--out", "FILE", true, "write the core points with their distances as a cloud: .las or .ply, significant ones coloured"},
         {"--metres", "", false, "bring all to metres first (default: lengths are in units of the files)"},
         csvOption("write the points that were taken, in the numbers of the file, or the distances")},
        tellCloud};
}

}  // namespace rubble::cli
