#include <QString>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/cli/evidence/placed_survey.h"
#include "app/cli/evidence/scanned_site.h"
#include "app/cli/evidence/scope_options.h"
#include "app/cli/exports/map_subject.h"
#include "app/cli/exports/run_surroundings.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/health_output.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/picture_options.h"
#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "core/evidence/cautions.h"
#include "core/evidence/evidence_list.h"
#include "core/evidence/no_evidence.h"
#include "core/evidence/surveys/stated_survey.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/case/terrain_reader.h"
#include "io/exports/provenance.h"
#include "io/exports/survey_files.h"
#include "io/run/acknowledgements.h"
#include "io/run/run_cautions.h"
#include "io/site/cause_evidence.h"
#include "io/site/input_files.h"
#include "io/site/site_place.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/survey_picture.h"

namespace rubble::cli {

namespace {

/// What is asked for, else as the case of the survey has it.
SurveySettings surveySettingsFrom(const Arguments& arguments, const Case& theCase) {
    SurveySettings settings = surveySettingsOf(theCase);
    settings.cell = parseLength(arguments, "--cell", settings.cell);
    settings.leastHeight = parseLength(arguments, "--least-height", settings.leastHeight, true);
    settings.liveThreshold = parseLength(arguments, "--live-threshold", settings.liveThreshold, true);
    settings.shiftMost = parseLength(arguments, "--shift-most", settings.shiftMost, true);
    settings.withFallen = parseOnOff(arguments, "--live", settings.withFallen);
    if (arguments.has("--survey-live")) {
        settings.showsFallen = parseOnOff(arguments, "--survey-live", true);
    }
    if (arguments.has("--noise")) {
        settings.noise = parseLength(arguments, "--noise", 0.0, true);
    }
    if (arguments.has("--ground-noise")) {
        settings.groundNoise = parseLength(arguments, "--ground-noise", 0.0, true);
    }
    if (arguments.has("--offset-error")) {
        settings.offsetError = parseLength(arguments, "--offset-error", 0.0, true);
    }
    if (const auto fit = arguments.value("--register")) {
        const std::optional<SurveyFit> named = surveyFitNamed(*fit);
        if (!named) {
            throw wrongValue("--register", *fit, "none, ground or debris");
        }
        settings.fit = *named;
    }
    if (const auto sectors = arguments.value("--sectors")) {
        if (!parseNumber(*sectors, settings.sectors) || settings.sectors < 1 || settings.sectors > 360) {
            throw wrongValue("--sectors", *sectors, "a whole number from 1 to 360");
        }
    }
    return settings;
}

/// The file of --survey, else the first survey of the case that shows debris, and what is said of it.
struct SurveyFile {
    std::string path;
    Site site;              ///< how it is brought to the local frame
    Case theCase = {};      ///< empty: none was named
    CaseInput stated = {};  ///< what the case says of it; without a SHA-256 if it names no such survey
};

SurveyFile surveyFile(const Arguments& arguments, const io::RunReader& run, Findings& findings) {
    SurveyFile file{arguments.value("--survey").value_or(""), run.origin().site};
    const std::string casePath = caseOfEvidence(arguments);
    if (!casePath.empty()) {
        file.theCase = io::isCaseFile(arguments.operand()) ? io::loadCase(casePath) : loadCaseOfRun(casePath, run.origin());
        file.site = file.theCase.site;
        // The ground that debris fell on is read as the run had it.
        file.site.groundClasses = run.origin().site.groundClasses;
    }
    for (const CaseInput& input : file.theCase.inputs) {
        if (file.path.empty() && input.role == InputRole::Survey && !input.before) {
            file.path = io::inputPath(casePath, input);
        }
    }
    if (file.path.empty()) {
        throw UsageError({"cli.no_survey", "There is no survey to compare {0} with.", {arguments.operand()}},
                         {"cli.no_survey.remedy", "Name a raster of heights or an outline with --survey FILE.", {}});
    }
    file.stated.path = file.path;
    if (const CaseInput* found = casePath.empty() ? nullptr : io::surveyOfFile(file.theCase, casePath, file.path)) {
        file.stated = *found;
        checkHasOverlap(*found);
    } else if (!arguments.has("--time")) {
        file.stated.instant = io::instantOfScan(file.path, findings);
    }
    return file;
}

std::string_view sourceText(SurveyNoise::Source source) {
    switch (source) {
        case SurveyNoise::Source::Stated:
            return "stated";
        case SurveyNoise::Source::Estimated:
            return "estimated";
        case SurveyNoise::Source::None:
            return "none";
        case SurveyNoise::Source::Unknown:
            break;
    }
    return "unknown";
}

TextTable sectorTable(const SurveyComparison& made) {
    TextTable table({{"direction", "direction"},
                     {"surveyed [m]", "survey_run_out_m"},
                     {"simulated [m]", "simulated_run_out_m"},
                     {"difference [m]", "difference_m"}});
    for (int s = 0; s < made.settings.sectors; ++s) {
        const double real = made.survey.runOut[static_cast<std::size_t>(s)];
        const double simulated = made.simulated.runOut[static_cast<std::size_t>(s)];
        table.add({textCell(sectorName(s, made.settings.sectors)), numberCell(real), numberCell(simulated),
                   numberCell(simulated - real)});
    }
    return table;
}

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json();
}

Json sideJson(const SurveySide& side) {
    Json object{{"area_m2", side.area}, {"volume_m3", number(side.volume)}};
    object["centroid_m"] = std::isfinite(side.centroid.x()) ? Json{side.centroid.x(), side.centroid.y()} : Json();
    object["run_out_m"] = side.runOut;
    return object;
}

/// What was measured beside the two sides: how well, and of what.
void addMeasures(Json& object, const SurveyComparison& made) {
    const SurveyNoise& noise = made.noise;
    object["debris_from_m"] = made.least;
    object["noise"] = {{"source", sourceText(noise.source)},        {"deviation_m", noise.deviation},
                       {"level_of_detection_m", noise.detection()}, {"correlation_m", number(noise.correlation)},
                       {"offset_m", number(noise.offset)},          {"cells", noise.cells}};
    const SurveyVolumes& volumes = made.volumes;
    object["volumes"] = made.isFootprint ? Json()
                                         : Json{{"fill_m3", volumes.fill},
                                                {"cut_m3", volumes.cut},
                                                {"net_m3", volumes.net()},
                                                {"not_detected_m3", volumes.undetected()},
                                                {"not_detected_fill_m3", volumes.undetectedFill},
                                                {"not_detected_cut_m3", volumes.undetectedCut},
                                                {"net_error_m3", number(volumes.netError.random)},
                                                {"fill_error_m3", number(volumes.fillError.random)},
                                                {"cut_error_m3", number(volumes.cutError.random)},
                                                {"net_systematic_m3", number(volumes.netError.systematic)},
                                                {"fill_systematic_m3", number(volumes.fillError.systematic)},
                                                {"cut_systematic_m3", number(volumes.cutError.systematic)}};
    object["reachable"] = Json();
    object["like_for_like"] = Json();
    if (made.seen) {
        object["reachable"] = {
            {"iou", number(made.seen->reachableIou)}, {"area_m2", made.seen->area}, {"volume_m3", number(made.seen->volume)}};
        object["like_for_like"] = {{"iou", number(made.seen->alikeIou)},
                                   {"area_difference_m2", made.seen->area - made.survey.area},
                                   {"volume_difference_m3", number(made.seen->volume - made.survey.volume)}};
    }
    const LeftOutDebris& left = made.leftOut;
    object["compared"] = {{"whole", made.settings.scope.whole()},        {"area_m2", left.comparedArea},
                          {"left_out_surveyed_m2", left.surveyedArea},   {"left_out_surveyed_m3", number(left.surveyedVolume)},
                          {"left_out_simulated_m2", left.simulatedArea}, {"left_out_simulated_m3", left.simulatedVolume}};
    const ApartDebris& apart = made.apart;
    object["apart"] = {{"places", apart.patches},
                       {"area_m2", apart.area},
                       {"volume_m3", made.isFootprint ? Json() : Json(apart.volume)},
                       {"nearest_m", apart.nearest},
                       {"farthest_m", apart.farthest}};
}

Json surveyJson(const SurveyComparison& made, const io::SurveyInput& input, const CaseInput& stated) {
    Json object;
    object["survey"] = {{"path", input.path},
                        {"sha256", input.sha256},
                        {"kind", made.isFootprint ? "footprint" : "heights"},
                        {"crs", input.crs},
                        {"of_run", input.ofRun.empty() ? Json() : Json(input.ofRun)},
                        {"taken", stated.taken.empty() ? Json() : Json(stated.taken)}};
    object["placed"] = registrationJson(stated.registration);
    object["time_s"] = made.time;
    object["interpolated"] = made.shown == FrameKind::Interpolated;
    object["cell_m"] = made.settings.cell;
    object["least_height_m"] = made.settings.leastHeight;
    object["live_structure"] = made.settings.withFallen;
    object["survey_live_structure"] = made.surveyShowsFallen ? Json(*made.surveyShowsFallen) : Json();
    object["fallen"] = {{"elements", made.fallen.elements}, {"volume_m3", made.fallen.volume}, {"held_parts", made.fallen.held}};
    object["standing"] = {{"area_m2", made.standing.area}, {"volume_m3", made.standing.volume}};
    object["registration"] = {{"to", surveyFitName(made.settings.fit)},
                              {"shift_m", {made.shift.by.x(), made.shift.by.y(), made.shift.by.z()}},
                              {"cells", made.shift.cells},
                              {"rms_before", made.shift.before},
                              {"rms_after", made.shift.after}};
    object["iou"] = number(made.iou);
    object["height_rms_m"] = number(made.heightRms);
    object["height_mean_m"] = number(made.heightMean);
    object["centroid_distance_m"] = number(made.centroidDistance);
    object["surveyed"] = sideJson(made.survey);
    object["simulated"] = sideJson(made.simulated);
    object["run_out_from_m"] = {made.centre.x(), made.centre.y()};
    object["directions"] = Json::array();
    for (int s = 0; s < made.settings.sectors; ++s) {
        object["directions"].push_back(sectorName(s, made.settings.sectors));
    }
    object["not_surveyed"] = {{"area_m2", made.unsurveyedArea}, {"volume_m3", made.unsurveyedVolume}};
    addMeasures(object, made);
    return object;
}

/// "133 surveyed, 120 simulated m2; surveyed likewise it would be 133 (0 %)"
std::string bothSides(double real, double simulated, double seen, const std::string& unit) {
    const double like = std::isfinite(seen) ? seen : simulated;
    const double share = std::round(1000.0 * (like - real) / real) / 10.0;
    const std::string compared =
        std::isfinite(share) ? " (" + std::string(share > 0.0 ? "+" : "") + englishNumber(share) + " %)" : "";
    const std::string text = englishNumber(real) + " surveyed, " + englishNumber(simulated) + " simulated " + unit;
    return std::isfinite(seen) ? text + "; surveyed likewise that is " + englishNumber(seen) + compared : text + compared;
}

std::string iouText(const SurveyComparison& made) {
    if (!std::isfinite(made.iou)) {
        return "none: neither side has debris";
    }
    const std::string text = englishNumber(made.iou);
    return made.seen && std::isfinite(made.seen->reachableIou) && std::isfinite(made.seen->alikeIou)
               ? text + "; a perfect simulation reaches " + englishNumber(made.seen->reachableIou) +
                     " on this grid; both sides surveyed alike " + englishNumber(made.seen->alikeIou)
               : text;
}

std::string detectionText(const SurveyNoise& noise) {
    if (noise.source == SurveyNoise::Source::Unknown) {
        return "not known: too little was surveyed far from all debris; state --noise and --ground-noise";
    }
    if (noise.source == SurveyNoise::Source::None) {
        return "0: a map made of a run has no noise";
    }
    std::string text = englishNumber(noise.detection()) + " m, noise of both surfaces " + std::string(sourceText(noise.source)) +
                       " as " + englishNumber(noise.deviation) + " m";
    if (noise.source == SurveyNoise::Source::Estimated) {
        text += " from " + englishInteger(static_cast<std::int64_t>(noise.cells)) + " cells far from all debris";
    }
    return std::isfinite(noise.correlation) ? text + "; it hangs together over " + englishNumber(noise.correlation) + " m" : text;
}

/// "12.5 +- 0.3 random +- not known"
std::string volumeText(double volume, const VolumeError& error) {
    const auto text = [](double part) { return std::isfinite(part) ? englishNumber(part) : std::string("not known"); };
    return englishNumber(volume) + " m3 (+- " + text(error.random) + " random, +- " + text(error.systematic) + " systematic)";
}

std::string volumesText(const SurveyVolumes& volumes) {
    return "fill above it " + volumeText(volumes.fill, volumes.fillError) + ", cut below it " +
           volumeText(volumes.cut, volumes.cutError) + ", net " + volumeText(volumes.net(), volumes.netError);
}

/// What the surveyed volumes leave out, and by how much they are too small.
std::string undetectedText(const SurveyComparison& made) {
    const SurveyVolumes& volumes = made.volumes;
    if (made.noise.source == SurveyNoise::Source::Unknown) {
        return "every height counts, for the level of detection is not known";
    }
    return "fill " + englishNumber(volumes.undetectedFill) + ", cut " + englishNumber(volumes.undetectedCut) + ", net " +
           englishNumber(volumes.undetectedNet()) + " m3 also lie below the level of detection";
}

/// "0.31 m RMS, -0.1 m mean"
std::string heightsText(const SurveyComparison& made) {
    return std::isfinite(made.heightRms) ? englishNumber(made.heightRms) + " m RMS, " + englishNumber(made.heightMean) + " m mean"
                                         : std::string("none: neither side has debris");
}

std::string centroidsText(const SurveyComparison& made) {
    if (std::isfinite(made.centroidDistance)) {
        return englishNumber(made.centroidDistance) + " m";
    }
    const bool surveyed = std::isfinite(made.survey.centroid.x());
    const bool simulated = std::isfinite(made.simulated.centroid.x());
    return std::string("not known: ") +
           (surveyed    ? "the simulated"
            : simulated ? "the surveyed"
                        : "neither") +
           " side has" + (surveyed || simulated ? " no" : "") + " debris";
}

std::string scopeText(const SurveyComparison& made) {
    const LeftOutDebris& left = made.leftOut;
    if (made.settings.scope.whole()) {
        return "all that was surveyed, " + englishNumber(left.comparedArea) + " m2";
    }
    return englishNumber(left.comparedArea) + " m2; left out " + englishNumber(left.surveyedArea) + " m2 surveyed, " +
           englishNumber(left.simulatedArea) + " m2 simulated debris" +
           (made.isFootprint ? ""
                             : " (" + englishNumber(left.surveyedVolume) + " and " + englishNumber(left.simulatedVolume) + " m3)");
}

void print(std::ostream& out, const SurveyComparison& made, const io::SurveyInput& input, const CaseInput& stated) {
    FactList facts;
    facts.add("survey", input.path + (made.isFootprint ? ", an outline" : ", heights"));
    facts.add("taken", stated.taken.empty() ? "not known" : stated.taken);
    facts.add("placed", placedText(input.frame, input.site, stated.registration));
    facts.add("time", englishNumber(made.time) + " s");
    facts.add("compared", scopeText(made));
    facts.add("footprint IoU", iouText(made));
    facts.add("area", bothSides(made.survey.area, made.simulated.area, made.seen ? made.seen->area : std::nan(""), "m2"));
    if (!made.isFootprint) {
        facts.add("volume with voids",
                  bothSides(made.survey.volume, made.simulated.volume, made.seen ? made.seen->volume : std::nan(""), "m3"));
        facts.add("height difference", heightsText(made));
        facts.add("surveyed against ground", volumesText(made.volumes));
        facts.add("not counted", undetectedText(made));
        facts.add("level of detection", detectionText(made.noise));
    }
    facts.add("centroids apart", centroidsText(made));
    facts.add("registration", made.settings.fit == SurveyFit::None
                                  ? std::string("none: the survey lies where it was placed")
                                  : "to the " + std::string(surveyFitName(made.settings.fit)) + ", moved by " +
                                        englishNumber(made.shift.by.x()) + ", " + englishNumber(made.shift.by.y()) + ", " +
                                        englishNumber(made.shift.by.z()) + " m; RMS " + englishNumber(made.shift.before) +
                                        " before, " + englishNumber(made.shift.after) + " after");
    facts.add("live structure", englishText(made.words));
    printHeading(out, "Survey against simulation");
    facts.print(out);
    printHeading(out, "Run-out from the middle of the structure, 95 % of the covered area");
    sectorTable(made).print(out);
}

void writePicture(const std::string& path, const SurveyComparison& made, const io::SurveyInput& input, const io::RunReader& run,
                  const Arguments& arguments) {
    const io::MapOrigin origin = io::surveyOrigin(run, made, input, caseOfEvidence(arguments));
    quietQt();
    figures::ensureGuiApplication();
    figures::SurveyPictureStyle style;
    if (const auto size = arguments.value("--size")) {
        style.pixels = parsePictureSize(*size);
    }
    style.textPixels = 25.0 * std::min(style.pixels.width() / 1600.0, style.pixels.height() / 800.0);
    style.place = io::SitePlace(input.frame, input.site).transform();
    style.system = input.frame.crs;
    style.provenance = "survey " + input.sha256.substr(0, 16) + ", " + io::footLine(run.origin());
    style.subject = origin.subject;
    style.cautions = pictureCautions(io::surveyCautions(run, input, made));
    figures::writePng(path, figures::surveyPicture(made, style));
    io::writeProvenance(path, origin.provenance);
}

ExitCode survey(const Arguments& arguments, Session& session) {
    surveySettingsFrom(arguments, {});  // what is wrong is said before anything is read
    std::optional<double> time = instantFrom(arguments);
    const std::vector<std::string> files = arguments.values("--out");
    const std::vector<std::string> inputs{arguments.operand(), arguments.value("--survey").value_or(arguments.operand())};
    for (const std::string& path : files) {
        if (!io::hasEnding(path, ".tif") && !io::hasEnding(path, ".tiff") && !io::hasEnding(path, ".png")) {
            throw wrongValue("--out", path, "a path that ends in .tif or .png");
        }
        checkOutputPath(path, inputs);
    }
    checkCsvPath(arguments, inputs);
    MapSubject subject = openMapSubject(arguments, session);
    Findings findings = subject.findings;
    SurveyFile file = surveyFile(arguments, *subject.run, findings);
    SurveySettings settings = surveySettingsFrom(arguments, file.theCase);
    if (!arguments.has("--time")) {
        time = file.stated.instant;
    }
    takeCloudRequest(arguments, file.stated.read);
    const io::SurveyRequest wanted =
        io::surveyRequest(subject.run->origin(), file.stated, arguments.value("--terrain").value_or(""));
    const MappedRun mapped{subject.inputs.fe.get(), subject.run.get(),      subject.run->fragments(),
                           subject.run->result(),   subject.inputs.terrain, subject.run->origin().scenario};
    const io::SiteWindow window(io::boundsAtRest(subject.inputs.fe->mesh()), debrisBounds(mapped, time));
    io::SurveyInput input = io::readSurvey(file.path, subject.inputs.frame, file.site, window, session.execution(), wanted);
    if (!file.stated.sha256.empty()) {
        input.findings.append(sameEvidence(file.theCase, file.stated.id));
    }
    findings.append(input.findings);
    if (arguments.has("--area") || arguments.has("--leave-out")) {
        file.stated.scope = scopeFrom(arguments, subject.inputs.frame, file.site, findings, session.execution());
    }
    takeStated(settings, file.theCase, file.stated, findings);
    settings.turn = io::SitePlace(input.frame, input.site).transform().angle;
    const SurveyComparison made = compareRunWithSurvey(mapped, time, input.survey, settings, session.execution());
    subject.instant = made.time;
    for (const std::string& path : files) {
        if (io::hasEnding(path, ".png")) {
            writePicture(path, made, input, *subject.run, arguments);
        } else {
            io::writeSurveyTiff(path, made, io::surveyOrigin(*subject.run, made, input, caseOfEvidence(arguments)),
                                session.execution());
        }
    }
    writeCsv(arguments, sectorTable(made));
    findings.append(made.findings);
    if (!file.stated.sha256.empty() && !io::InputDigest{input.sha256, input.fileSha256}.is(file.stated.sha256)) {
        findings.add({"survey.changed", "the survey is not the one the case was saved with", {}},
                     {"survey.changed.remedy", "find the file with the SHA-256 of the case, or accept it as it is", {}}, file.path);
    }
    findings = noEvidenceFirst(findings);
    conclude(
        arguments, session, subject, findings, [&] { return surveyJson(made, input, file.stated); },
        [&](std::ostream& out) { print(out, made, input, file.stated); });
    return ExitCode::Ok;
}

}  // namespace

Command surveyCommand() {
    return {
        "survey",
        "RUN|FE|CASE",
        "simulated debris against a surveyed height model or outline",
        "Holds the debris of a recorded run, or of a case or FE file that is simulated first, against a survey: difference "
        "map, overlap "
        "of the footprints, volume, run-out by direction, centroids.",
        joined(
            {{{"--survey", "FILE", false,
               "raster of heights, point cloud, or polygons in a GeoPackage, GeoJSON or Shapefile (default: that of the case)"},
              columnsOption(),
              systemOption(),
              evidenceCaseOption(),
              {"--time", "SECONDS", false, "instant on the file's clock, or end (default: as the case says, else end)"},
              {"--cell", "M", false, "side of the cells that are compared, m (default: as the case has it, else 0.5)"},
              {"--least-height", "M", false,
               "height above the ground from which there is debris, m (default: as the case has it, else 0.2)"},
              {"--live", "on|off", false, "whether fallen live structure counts as debris (default: as the case has it, else on)"},
              {"--survey-live", "on|off", false,
               "whether the survey shows fallen live structure (default: as the case or the file says, else not known)"},
              {"--live-threshold", "M", false, "live structure has fallen if it moved farther than this, m (default: 1)"},
              areaOption(),
              leaveOutOption(),
              {"--noise", "M", false, "standard deviation of the surveyed heights, m (default: as the case says, else estimated)"},
              {"--ground-noise", "M", false, "the same of the ground they are held above, m"},
              {"--offset-error", "M", false,
               "standard deviation of an offset that all surveyed heights may have together, m (default: as the case says, else "
               "not "
               "known)"},
              {"--register", "none|ground|debris", false,
               "what the survey is moved to before, by least squares (default: as the case has it, else none)"},
              {"--shift-most", "M", false, "that it is moved in plan at most, m (default: 5)"},
              {"--sectors", "N", false, "directions in which run-out is measured, 1 to 360 (default: 8)"},
              {"--out", "FILE", true, "a file to write: .tif (difference, surveyed, simulated) or .png"},
              {"--size", "WxH", false, "pixels of a picture (default: 1600x1000)"}},
             siteOptions(),
             {csvOption("write the table of directions")}}),
        survey};
}

}  // namespace rubble::cli
