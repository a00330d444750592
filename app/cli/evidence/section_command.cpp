#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

#include "app/cli/evidence/placed_survey.h"
#include "app/cli/evidence/scanned_site.h"
#include "app/cli/exports/map_subject.h"
#include "app/cli/exports/run_surroundings.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/picture_options.h"
#include "app/cli/frame/text_output.h"
#include "core/base/csv_text.h"
#include "core/base/error.h"
#include "core/base/unknown.h"
#include "core/evidence/site_section.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/exports/provenance.h"
#include "io/exports/survey_files.h"
#include "io/run/run_cautions.h"
#include "io/site/cause_evidence.h"
#include "io/site/site_place.h"
#include "io/site/surveys/measured_points.h"
#include "io/site/surveys/run_section.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/report/section_picture.h"

namespace rubble::cli {

namespace {

constexpr std::array<const char*, 5> sectionThings{"nothing", "debris", "fallen_structure", "structure", "ground"};
/// The line of --line, m, local. Without one it is found along the points that are given: only width and step are set.
SectionLine lineFrom(const Arguments& arguments, const io::SitePlace& place) {
    SectionLine line;
    line.width = parseLength(arguments, "--width", line.width);
    line.step = parseLength(arguments, "--step", line.step);
    if (!arguments.has("--line") && arguments.has("--points")) {
        return line;
    }
    const std::string text = arguments.value("--line").value_or("");
    const std::vector<std::string> parts = splitAtCommas(text);
    std::array<double, 4> numbers{};
    bool sound = parts.size() == numbers.size();
    for (std::size_t k = 0; sound && k < numbers.size(); ++k) {
        sound = parseNumber(parts[k], numbers[k]) && std::isfinite(numbers[k]);
    }
    if (!sound) {
        throw wrongValue("--line", text, "easting and northing of both ends in metres, such as 10,-5,10,25");
    }
    line.from = place.planToLocal({numbers[0], numbers[1]});
    line.to = place.planToLocal({numbers[2], numbers[3]});
    return line;
}

/// A file of points, and how it was read.
struct MeasuredFile {
    std::string path;
    CloudRequest read;
};

/// What was measured, and when by the case.
struct MeasuredSite {
    std::vector<MeasuredSet> sets;    ///< by file
    std::vector<MeasuredFile> files;  ///< beside the sets
    std::optional<double> instant;
};

/// That points are asked for in a section which the case holds to say something else.
void tellHeldOtherwise(const CaseInput& stated, Findings& findings) {
    if (stated.held == PointsHeld::Outline) {
        findings.add(
            {"section.held_otherwise", "the case holds these points as the edge of the debris; they stand in this section too", {}},
            {"section.held_otherwise.remedy", "leave them out of --points, or hold them for sections", {}}, stated.path);
    }
}

MeasuredSite measuredFrom(const Arguments& arguments, const MapSubject& subject, const Site& site, Findings& findings,
                          const Execution& execution) {
    MeasuredSite all;
    const std::string casePath = caseOfEvidence(arguments);
    const Case theCase = casePath.empty()                      ? Case()
                         : io::isCaseFile(arguments.operand()) ? io::loadCase(casePath)
                                                               : loadCaseOfRun(casePath, subject.run->origin());
    std::set<std::optional<double>> instants;
    for (const std::string& path : arguments.values("--points")) {
        io::MeasuredRequest request{path, {}, subject.inputs.frame, site};
        if (!casePath.empty()) {
            const CaseInput stated = io::statedOfFile(theCase, casePath, path, {}, findings);
            request.placed = stated.registration;
            request.scope = stated.scope;
            request.read = stated.read;
            if (io::surveyOfFile(theCase, casePath, path) != nullptr) {
                tellHeldOtherwise(stated, findings);
                instants.insert(stated.instant);
            }
        }
        takeCloudRequest(arguments, request.read);
        all.files.push_back({path, request.read});
        all.sets.push_back({std::filesystem::path(path).filename().string(), io::readMeasuredPoints(request, findings, execution)});
    }
    if (instants.size() > 1 && !arguments.has("--time")) {
        throw UsageError(
            {"cli.instants_differ", "The case holds the points of {0} against different instants of the run", {casePath}},
            {"cli.instants_differ.remedy", "Give --time, or cut a section for each file of --points.", {}});
    }
    all.instant = instants.empty() ? std::nullopt : *instants.begin();
    return all;
}

io::RunSection makeSection(const Arguments& arguments, const MapSubject& subject, const Execution& execution) {
    const Site& at = subject.run->origin().site;
    const io::SitePlace place(subject.inputs.frame, at);
    SectionLine line = lineFrom(arguments, place);
    Findings findings;
    const MeasuredSite measured = measuredFrom(arguments, subject, at, findings, execution);
    if (!arguments.has("--line")) {
        line = io::lineAlongPoints(measured.sets, line, findings);
    }
    ScannedSite site =
        scannedSite(*subject.run, subject.inputs, arguments.has("--time") ? instantFrom(arguments) : measured.instant,
                    parseLength(arguments, "--live-threshold", 1.0, true), execution);
    io::RunSection made = io::cutRun(std::move(site.shape), site.ground, line, measured.sets, execution);
    made.section.water = subject.run->origin().scenario.effects.waterLevel.value_or(unknown);
    findings.append(made.findings);
    made.findings = std::move(findings);
    made.zero = place.transform().height;
    for (const MeasuredFile& file : measured.files) {
        io::addMeasuredFile(made, {file.path, io::sha256OfFile(file.path)}, file.read, subject.run->origin().fingerprint.hex());
    }
    return made;
}

TextTable stepTable(const io::RunSection& made) {
    TextTable table({{"along [m]", "along_m"},
                     {"ground [m]", "ground_m"},
                     {"simulated [m]", "simulated_m"},
                     {"of", "of"},
                     {"points", "points"},
                     {"measured [m]", "measured_m"},
                     {"difference [m]", "difference_m"}});
    for (const SectionStep& step : made.section.steps) {
        table.add({numberCell(step.along), numberCell(step.ground + made.zero), numberCell(step.simulated + made.zero),
                   textCell(sectionThings[static_cast<std::size_t>(step.thing)]), integerCell(step.points),
                   numberCell(step.measured + made.zero), numberCell(step.simulatedAtPoints - step.measured)});
    }
    return table;
}

void drawSection(const std::string& path, const io::RunSection& made, const Arguments& arguments, const io::RunReader& run) {
    quietQt();
    figures::ensureGuiApplication();
    figures::SectionPictureStyle style;
    if (const auto size = arguments.value("--size")) {
        style.pixels = parsePictureSize(*size);
    }
    style.textPixels = 0.028 * style.pixels.height();
    style.zero = made.zero;
    const io::SitePlace place(run.origin().frame, run.origin().site);
    const SectionLine& line = made.section.line;
    style.note = figures::SectionNote{made.time,
                                      place.planToWorld(line.from),
                                      place.planToWorld(line.to),
                                      line.width,
                                      place.system(),
                                      QString::fromStdString(pictureCautions(io::sectionCautions(run, made))),
                                      io::sectionFoot(run, made)};
    const std::string provenance = io::sectionProvenance(run, made, place);
    figures::writePng(path, figures::sectionPicture(made.section, style), provenance);
    io::writeProvenance(path, provenance);
}

Json sectionNumber(double number) {
    return std::isfinite(number) ? Json(number) : Json();
}

Json sectionJson(const io::RunSection& made, const io::SitePlace& place) {
    const SiteSection& section = made.section;
    Json sources = Json::array();
    for (const SectionSource& source : section.sources) {
        sources.push_back({{"name", source.name},
                           {"points", source.agreement.points},
                           {"points_compared", source.agreement.compared},
                           {"difference_mean_m", sectionNumber(source.agreement.mean)},
                           {"difference_rms_m", sectionNumber(source.agreement.rms)}});
    }
    const Eigen::Vector2d from = place.planToWorld(section.line.from);
    const Eigen::Vector2d to = place.planToWorld(section.line.to);
    return {{"time_s", made.time},
            {"line_m", {from.x(), from.y(), to.x(), to.y()}},
            {"length_m", section.line.length()},
            {"width_m", section.line.width},
            {"step_m", section.line.step},
            {"water_m", sectionNumber(section.water + place.transform().height)},
            {"points", section.agreement.points},
            {"points_compared", section.agreement.compared},
            {"difference_mean_m", sectionNumber(section.agreement.mean)},
            {"difference_rms_m", sectionNumber(section.agreement.rms)},
            {"sources", std::move(sources)},
            {"covered_m", section.covered},
            {"measured_area_m2", sectionNumber(section.covered > 0.0 ? section.measuredArea : unknown)},
            {"simulated_area_m2", sectionNumber(section.covered > 0.0 ? section.simulatedArea : unknown)}};
}

void addAgreement(FactList& facts, const std::string& of, const SectionAgreement& agreement) {
    facts.add(of + "measured points", englishInteger(agreement.points) + ", " + englishInteger(agreement.compared) +
                                          " of them where the simulation has a surface");
    if (agreement.compared > 0) {
        facts.add(of + "simulated less measured",
                  englishNumber(agreement.mean) + " m in the mean, " + englishNumber(agreement.rms) + " m RMS");
    }
}

/// To the millimetre, as --line takes it.
std::string placeText(const Eigen::Vector2d& place) {
    const auto number = [](double value) { return exactNumber(std::round(1000.0 * value) / 1000.0); };
    return number(place.x()) + "," + number(place.y());
}

void printSection(std::ostream& out, const io::RunSection& made, const io::SitePlace& place, bool along) {
    const SiteSection& section = made.section;
    FactList facts;
    facts.add("time", englishNumber(made.time) + " s");
    facts.add("section", englishNumber(section.line.length()) + " m long, " + englishNumber(section.line.width) +
                             " m wide, steps of " + englishNumber(section.line.step) + " m");
    facts.add(along ? "line along the points" : "line", placeText(place.planToWorld(section.line.from)) + " to " +
                                                            placeText(place.planToWorld(section.line.to)) +
                                                            " (easting,northing, m)");
    addAgreement(facts, "", section.agreement);
    if (section.agreement.compared > 0) {
        facts.add("area above ground", englishNumber(section.measuredArea) + " measured, " + englishNumber(section.simulatedArea) +
                                           " simulated m2, over " + englishNumber(section.covered) + " m with points");
    }
    // One set is all of them.
    for (const SectionSource& source : section.sources.size() > 1 ? section.sources : std::vector<SectionSource>()) {
        addAgreement(facts, source.name + ": ", source.agreement);
    }
    printHeading(out, "Section through the simulated site and what was measured");
    facts.print(out);
}

ExitCode section(const Arguments& arguments, Session& session) {
    const std::vector<std::string> files = arguments.values("--out");
    std::vector<std::string> inputs = arguments.values("--points");
    inputs.push_back(arguments.operand());
    for (const std::string& path : files) {
        if (!io::hasEnding(path, ".png")) {
            throw wrongValue("--out", path, "a path that ends in .png");
        }
        checkOutputPath(path, inputs);
    }
    checkCsvPath(arguments, inputs);
    lineFrom(arguments, io::SitePlace(Frame(), Site()));
    instantFrom(arguments);
    MapSubject subject = openMapSubject(arguments, session);
    const io::RunSection made = makeSection(arguments, subject, session.execution());
    subject.instant = made.time;
    for (const std::string& path : files) {
        drawSection(path, made, arguments, *subject.run);
    }
    writeCsv(arguments, stepTable(made));
    Findings findings = subject.findings;
    findings.append(made.findings);
    const io::SitePlace place(subject.inputs.frame, subject.run->origin().site);
    const bool along = !arguments.has("--line");
    conclude(
        arguments, session, subject, findings,
        [&] {
            Json json = sectionJson(made, place);
            json["along_points"] = along;
            return json;
        },
        [&](std::ostream& out) { printSection(out, made, place, along); });
    return ExitCode::Ok;
}

}  // namespace

Command sectionCommand() {
    return {
        "section",
        "RUN|FE|CASE",
        "a section through the simulated site and what was measured of the real one",
        "Cuts what a recorded run, or a case or FE file that is simulated first, leaves on the site along a line, and holds points "
        "of a total station, a drawing or a cloud beside the line against it: heights, differences and areas.",
        joined({{{"--line", "E,N,E,N", false, "easting and northing of both ends, m (default: along the points)"},
                 {"--points", "FILE", true, "measured points: table of a total station, DXF or point cloud"},
                 columnsOption(),
                 systemOption(),
                 {"--width", "M", false, "points within half of it to either side count (default: 1)"},
                 {"--step", "M", false, "along the line, what is drawn and summed (default: 0.25)"},
                 {"--time", "SECONDS", false, "instant on the file's clock, or end (default: that of the case, else end)"},
                 {"--live-threshold", "M", false, "live structure has fallen if it moved farther than this, m (default: 1)"},
                 {"--out", "FILE", true, "a picture to write: .png"},
                 {"--size", "WxH", false, "pixels of a picture (default: 1600x900)"},
                 evidenceCaseOption()},
                siteOptions(),
                {csvOption("write a row for each step")}}),
        section};
}

}  // namespace rubble::cli
