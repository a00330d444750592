#include <array>
#include <chrono>
#include <memory>
#include <vector>

#include "app/cli/evidence/cloud_distance_output.h"
#include "app/cli/evidence/cloud_output.h"
#include "app/cli/evidence/placed_survey.h"
#include "app/cli/evidence/scanned_site.h"
#include "app/cli/evidence/scope_options.h"
#include "app/cli/exports/map_subject.h"
#include "app/cli/exports/run_surroundings.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/run_inputs.h"
#include "core/base/csv_text.h"
#include "core/base/elapsed.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/case/terrain_reader.h"
#include "io/exports/survey_files.h"
#include "io/site/cause_evidence.h"
#include "io/site/clouds/distance_files.h"
#include "io/site/clouds/e57/placed_photographs.h"
#include "io/site/clouds/point_writer.h"
#include "io/site/survey_file.h"
#include "io/site/surveys/survey_registration.h"

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
        const std::vector<unsigned char> bytes = cloud.photograph(photograph);
        paths.push_back(*folder + "/" + io::photographFileName(photograph, p));
        io::writeIn(paths.back(), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    return paths;
}

/// Options that ask for distances, and mean nothing without another cloud.
constexpr std::array<std::string_view, 19> distanceOptions{"--case",
                                                           "--pairs",
                                                           "--pairs-error",
                                                           "--fit",
                                                           "--cell",
                                                           "--out",
                                                           "--cores",
                                                           "--normal-scale",
                                                           "--projection-scale",
                                                           "--depth",
                                                           "--registration-error",
                                                           "--metres",
                                                           "--scanner",
                                                           "--time",
                                                           "--live-threshold",
                                                           "--area",
                                                           "--leave-out",
                                                           "--fe",
                                                           "--terrain"};

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

CloudDistanceSettings distanceSettingsFrom(const Arguments& arguments) {
    CloudDistanceSettings settings;
    settings.normalRadius = scaleFrom(arguments, "--normal-scale");
    settings.projectionRadius = scaleFrom(arguments, "--projection-scale");
    settings.depth = scaleFrom(arguments, "--depth");
    if (arguments.has("--registration-error")) {
        settings.registrationError = parseLength(arguments, "--registration-error", 0.0, true);
    }
    return settings;
}

/// @param unit  m to each unit that the polygons are brought to
Outline inUnits(Outline outline, double unit) {
    for (OutlinePolygon& polygon : outline.polygons) {
        for (OutlineRing& ring : polygon) {
            for (Eigen::Vector2d& corner : ring) {
                corner /= unit;
            }
        }
    }
    return outline;
}

/// What --fit names as not moved, m, local; unset if it was not given.
std::optional<Outline> stableFrom(const Arguments& arguments, const Frame& frame, const Site& site, Findings& findings,
                                  const Execution& execution) {
    const auto given = arguments.value("--fit");
    if (!given) {
        return std::nullopt;
    }
    return *given == "all" ? Outline() : io::readScope(*given, frame, site, findings, execution);
}

void checkDistanceFiles(const Arguments& arguments, const std::vector<std::string>& inputs) {
    checkCsvPath(arguments, inputs);
    for (const std::string& path : arguments.values("--out")) {
        if (!io::namesWrittenCloud(path)) {
            throw wrongValue("--out", path, "a path that ends in .las or .ply");
        }
        checkOutputPath(path, inputs);
    }
}

void writeDistanceFiles(const Arguments& arguments, const io::CloudComparison& made) {
    if (const auto path = arguments.value("--csv")) {
        io::writeAtomically(*path, [&](std::ostream& out) { io::writeDistances(out, made); });
    }
    for (const std::string& path : arguments.values("--out")) {
        io::writeDistanceCloud(path, made);
    }
}

/// Options that mean something against a run alone.
constexpr std::array<std::string_view, 6> runOptions{"--case", "--scanner", "--time", "--live-threshold", "--fe", "--terrain"};

/// What the case of --case says of the cloud; without it which instant of a run it says it shows.
CaseInput statedOfCloud(const Arguments& arguments, const io::RunOrigin& origin, Findings& findings) {
    const auto path = arguments.value("--case");
    if (path) {
        return io::statedOfFile(loadCaseOfRun(*path, origin), *path, arguments.operand(), {}, findings);
    }
    CaseInput stated;
    if (!arguments.has("--time")) {
        stated.instant = io::instantOfScan(arguments.operand(), findings);
    }
    return stated;
}

ExitCode compareWithRun(const Arguments& arguments, Session& session, const std::string& path,
                        const std::shared_ptr<io::RunReader>& reader) {
    for (const std::string_view option : {"--cores", "--metres"}) {
        if (arguments.has(option)) {
            throw UsageError(
                {"cli.not_against_run", "{0} has no meaning against a run", {std::string(option)}},
                {"cli.not_against_run.remedy", "Leave it out: a run is in metres, and cores are points of the cloud.", {}});
        }
    }
    const io::RunReader& run = *reader;
    io::RunDistanceRequest request;
    request.cloud = arguments.operand();
    request.run = path;
    request.site = run.origin().site;
    request.scanners = scannersFrom(arguments);
    request.settings = distanceSettingsFrom(arguments);
    if (arguments.has("--cell")) {
        request.cell = parseLength(arguments, "--cell", 0.0);
    }
    checkDistanceFiles(arguments, {request.cloud, path});
    Findings findings;
    const CaseInput stated = statedOfCloud(arguments, run.origin(), findings);
    request.placed = stated.registration;
    request.scanners = request.scanners.empty() ? stated.scanners : request.scanners;
    request.read = stated.read;
    takeCloudRequest(arguments, request.read);
    if (!request.settings.registrationError && !arguments.has("--fit") && !arguments.has("--pairs")) {
        request.settings.registrationError = stated.offsetError;
    }
    const std::optional<double> time = arguments.has("--time") ? instantFrom(arguments) : stated.instant;
    const MapSubject subject{nullptr, path, reader, openInputsOfRun(path, run.origin(), arguments, session, &findings), {}};
    const Inputs& inputs = subject.inputs;
    request.frame = inputs.frame;
    request.fingerprint = run.origin().fingerprint.hex();
    if (const auto pairs = arguments.value("--pairs")) {
        const PairFit fit = io::placeByPairs({request.cloud, *pairs, request.read, request.frame, request.site,
                                              io::boundsAtRest(inputs.fe->mesh()), pairsErrorFrom(arguments)});
        findings.append(fit.findings);
        request.placed = fit.registration;
    }
    request.stable = stableFrom(arguments, request.frame, request.site, findings, session.execution());
    request.scope = stated.scope;
    if (arguments.has("--area") || arguments.has("--leave-out")) {
        request.scope = scopeFrom(arguments, request.frame, request.site, findings, session.execution());
    }
    ScannedSite site = scannedSite(run, inputs, time, parseLength(arguments, "--live-threshold", 1.0, true), session.execution());
    io::RunDistance made = io::compareCloudWithSite(request, std::move(site.shape), site.ground, site.volumes, session.execution());
    findings.append(made.compared.findings);
    writeDistanceFiles(arguments, made.compared);
    std::vector<std::string> written = arguments.values("--out");
    if (const auto csv = arguments.value("--csv")) {
        written.push_back(*csv);
    }
    if (!written.empty()) {
        const std::string provenance = io::distanceProvenance(*subject.run, made, io::sha256OfFile(request.cloud));
        for (const std::string& file : written) {
            io::writeProvenance(file, provenance);
        }
    }
    conclude(
        arguments, session, subject, findings, [&] { return runDistanceJson(made, request.settings); },
        [&](std::ostream& out) { printRunDistance(out, made, request.settings); });
    return ExitCode::Ok;
}

/// Polygons of what did not move and of what is compared, in the unit of a comparison of two clouds.
void takePolygons(const Arguments& arguments, io::CloudComparisonRequest& request, Findings& findings, const Execution& execution) {
    if (!arguments.has("--fit") && !arguments.has("--area") && !arguments.has("--leave-out")) {
        return;
    }
    const io::CloudHead head = io::openCloud(request.first, request.read)->head();
    Frame frame;
    frame.crs = head.crs;
    const double unit = request.metres ? 1.0 : head.units.metres;
    request.stable = stableFrom(arguments, frame, {}, findings, execution);
    if (request.stable) {
        request.stable = inUnits(std::move(*request.stable), unit);
    }
    const SurveyScope scope = scopeFrom(arguments, frame, {}, findings, execution);
    request.scope = {inUnits(scope.area, unit), inUnits(scope.leftOut, unit)};
}

ExitCode compareCloud(const Arguments& arguments, Session& session) {
    const std::string against = *arguments.value("--against");
    if (io::isCaseFile(against)) {
        throw UsageError({"cli.against_case", "{0} is a case, and what it leads to is not simulated yet", {against}},
                         {"cli.against_case.remedy", "Simulate it with rubble-cli run, and give the file of the run.", {}});
    }
    if (const std::shared_ptr<io::RunReader> run = runAt(against)) {
        return compareWithRun(arguments, session, against, run);
    }
    for (const std::string_view option : runOptions) {
        if (arguments.has(option)) {
            throw UsageError({"cli.needs_run", "{0} means something against a run alone", {std::string(option)}},
                             {"cli.needs_run.remedy", "Leave it out, or give the file of a run with --against.", {}});
        }
    }
    io::CloudComparisonRequest request;
    request.first = arguments.operand();
    request.second = against;
    request.cores = arguments.value("--cores").value_or("");
    takeCloudRequest(arguments, request.read);
    request.pairs = arguments.value("--pairs").value_or("");
    request.control = pairsErrorFrom(arguments);
    request.metres = arguments.has("--metres");
    request.settings = distanceSettingsFrom(arguments);
    Findings findings;
    takePolygons(arguments, request, findings, session.execution());
    if (arguments.has("--cell")) {
        request.cell = parseLength(arguments, "--cell", 0.0);
    }
    checkDistanceFiles(arguments, {request.first, request.second, request.cores.empty() ? request.first : request.cores});
    io::CloudComparison made = io::compareClouds(request, session.execution());
    findings.append(made.findings);
    made.findings = std::move(findings);
    writeDistanceFiles(arguments, made);
    if (arguments.json()) {
        printJson(session, cloudDistanceJson(made, request.settings));
    } else {
        printCloudDistance(session.out(), made, request.settings);
    }
    return ExitCode::Ok;
}

ExitCode tellCloud(const Arguments& arguments, Session& session) {
    if (arguments.has("--against")) {
        if (arguments.has("--index")) {
            throw UsageError({"cli.not_with_against", "{0} has no meaning with a second cloud", {"--index"}},
                             {"cli.not_with_against.remedy", "Give it in a call of its own.", {}});
        }
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
    CloudRequest request;
    takeCloudRequest(arguments, request);
    const std::unique_ptr<io::PointCloud> cloud = io::openCloud(arguments.operand(), request);
    std::optional<io::OpenedOctree> index;
    const auto from = std::chrono::steady_clock::now();
    if (arguments.has("--index")) {
        index = io::openOctree(arguments.operand(), request, session.execution());
    }
    const double seconds = secondsSince(from);
    const bool readAlready = index && index->summary && !arguments.has("--csv");
    const io::CloudSummary summary = readAlready ? *index->summary : readAll(arguments, *cloud, session.execution());
    const std::vector<std::string> photographs = writePhotographs(arguments, *cloud);
    if (arguments.json()) {
        Json object = cloudJson(*cloud, summary, photographs);
        object["octree"] = index ? octreeJson(*index, seconds) : Json();
        printJson(session, object);
    } else {
        printCloud(session.out(), *cloud, summary);
        if (index) {
            printOctree(session.out(), *index, seconds);
        }
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
        "measures the distance to another cloud or to a run, with roughness and level of detection at 95 %.",
        {systemOption(),
         columnsOption(),
         {"--photographs", "FOLDER", false, "write the pictures that lie in an E57"},
         {"--index", "", false,
          "make an octree beside the cloud, or in the cache folder where that cannot be written to, for views by level of detail; "
          "one that is there and of this file is kept"},
         {"--against", "CLOUD|RUN", false,
          "measure the distance from FILE to this cloud, or to the simulated site of a run, along the local normal (M3C2)"},
         {"--cores", "CLOUD", false,
          "points to measure at (default: those of FILE, one to each cube as wide as the projection scale)"},
         {"--normal-scale", "R", false, "radius about a core within which points of FILE give the normal"},
         {"--projection-scale", "R", false, "radius of the cylinder along the normal in which both clouds are averaged"},
         {"--depth", "D", false, "of the cylinder, to each side of the core"},
         {"--registration-error", "E", false, "by which one cloud may be out of place against the other (default: not known)"},
         {"--out", "FILE", true, "write the core points with their distances as a cloud: .las or .ply, significant ones coloured"},
         {"--pairs", "FILE", false,
          "move one to the other first by three pairs or more: a table of survey_x,survey_y,survey_z in CLOUD (in FILE against a "
          "run), x_m,y_m,z_m in FILE (in the case)"},
         pairsErrorOption("E"),
         {"--fit", "FILE|all", false,
          "fit one to the other first by what did not move: polygons of it, or all; the error of the fit is the registration "
          "error"},
         {"--cell", "M", false,
          "also the volumes between the two, over square cells of this side, m against a run: cut, fill and net"},
         {"--case", "CASE", false, "against a run: the case that says when FILE was taken, what counts of it and how it lies"},
         {"--metres", "", false, "bring all to metres first (default: lengths are in units of the files)"},
         scannerOption("against a run: where a scanner stood, easting, northing and height, m (default: as FILE says)"),
         {"--time", "SECONDS", false,
          "against a run: instant on the file's clock, or end (default: as case or scan say, else end)"},
         {"--live-threshold", "M", false, "against a run: live structure has fallen if it moved farther than this, m (default: 1)"},
         areaOption(),
         leaveOutOption(),
         feOption(),
         runTerrainOption(),
         csvOption("write the points that were taken, in the numbers of the file, or the distances")},
        tellCloud};
}

}  // namespace rubble::cli
