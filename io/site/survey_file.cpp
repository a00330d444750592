#include "io/site/survey_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/error.h"
#include "core/evidence/no_evidence.h"
#include "io/site/clouds/height_source.h"
#include "io/site/height_reading.h"
#include "io/site/input_files.h"
#include "io/site/outline_file.h"
#include "io/site/surveys/evidence_origin.h"
#include "io/site/surveys/measured_points.h"
#include "io/site/surveys/survey_placing.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

void takeOutline(SurveyInput& input, OutlineReading outline, const SurveyRequest& request) {
    input.survey.isFootprint = true;
    input.survey.footprint = std::move(outline.outline);
    input.survey.reached = outline.debrisMap;
    input.crs = std::move(outline.crs);
    input.findings = std::move(outline.findings);
    if (outline.fallen > 0) {
        input.survey.showsFallen = request.withFallen;
    }
}

void takeHeights(SurveyInput& input, HeightReading heights, const SurveyRequest& request) {
    SurveyHeights& taken = input.survey.heights;
    static_cast<HeightGrid&>(taken) = std::move(heights.raster);
    taken.lattice = std::move(heights.lattice);
    taken.aboveGround = request.aboveGround || heights.debrisMap;
    taken.everywhere = heights.debrisMap;
    input.crs = std::move(heights.crs);
    input.findings = std::move(heights.findings);
    const std::int64_t gaps = countGaps(taken);
    if (heights.debrisMap) {
        // What has no height there is ground without debris.
        std::replace_if(taken.heights.begin(), taken.heights.end(), [](double height) { return std::isnan(height); }, 0.0);
        input.survey.showsFallen = request.withFallen;
        input.findings.add({"survey.debris_map", "the survey is a debris map: its heights are taken above the ground", {}},
                           {"survey.debris_map.remedy", "none is needed; the comparison is between two simulations", {}},
                           input.path);
    } else if (gaps > 0) {
        const auto all = static_cast<double>(taken.heights.size());
        input.findings.add({"survey.gaps",
                            "{0} of {1} heights of the survey have no value ({2} %): nothing was surveyed there",
                            {gaps, taken.heights.size(), 100.0 * static_cast<double>(gaps) / all}},
                           {"survey.gaps.remedy", "none is needed; the comparison leaves these places out", {}}, input.path, gaps);
    }
}

}  // namespace

Outline readScope(const std::string& path, const Frame& frame, const Site& site, Findings& findings, const Execution& execution) {
    SurveyInput read = readSurvey(path, frame, site, Aabb(), execution,
                                  {.holds = SurveyRequest::Holds::Outline, .withFallen = true, .evidence = false});
    findings.append(read.findings);
    return std::move(read.survey.footprint);
}

SurveyInput readSurvey(const std::string& path, const Frame& frame, const Site& site, const SiteWindow& window,
                       const Execution& execution, const SurveyRequest& request) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored) || fs::file_size(path, ignored) == 0) {
        throw WorldError({"survey.missing", "There is no survey {0}, or it is empty", {path}},
                         {"survey.missing.remedy", "Check the path, or copy the file again.", {}});
    }
    execution.check();
    SurveyInput input;
    input.path = path;
    input.frame = frame;
    input.site = site;
    input.survey.name = fs::path(path).filename().string();
    std::optional<OutlineReading> outline;
    if (request.edge && request.holds != SurveyRequest::Holds::Heights && holdsMeasuredPoints(path)) {
        input.survey.isFootprint = true;
        input.survey.footprint = readMeasuredEdge({path, request.read, frame, site}, input.findings, execution);
    } else if (request.holds != SurveyRequest::Holds::Heights) {
        outline = readOutline(path, frame, site, request.withFallen, execution);
    }
    if (outline && !request.read.empty()) {
        refuseRequestOfNoCloud(path);
    }
    if (input.survey.isFootprint) {
        // The edge of measured points is there already.
    } else if (outline) {
        takeOutline(input, std::move(*outline), request);
    } else if (request.holds == SurveyRequest::Holds::Outline) {
        throw ParseError({"survey.no_outline", "{0} is no file of polygons that can be read", {path}},
                         {"survey.no_outline.remedy", "Give a GeoPackage, GeoJSON, Shapefile, FlatGeobuf or KML.", {}});
    } else {
        SiteWindow unmoved = window;
        if (request.registration) {
            unmoved = {boxBack(*request.registration, window.structure), boxBack(*request.registration, window.debris)};
        }
        takeHeights(
            input,
            readHeights(
                path, frame, site, unmoved, execution,
                {.aboveGround = request.aboveGround, .withFallen = request.withFallen, .surface = true, .read = request.read}),
            request);
        if (!request.ground.empty() && !input.survey.heights.aboveGround) {
            // What it takes liberties with is told where the terrain is opened.
            HeightReading ground = readHeights(request.ground, frame, site, window, execution, {.read = request.groundRead});
            SurveyHeights& own = input.survey.ground.emplace();
            static_cast<HeightGrid&>(own) = std::move(ground.raster);
            own.lattice = std::move(ground.lattice);
        }
    }
    if (request.registration) {
        placeSurvey(input, *request.registration);
    }
    InputDigest digest = digestOfInput(path, InputRole::Survey, execution);
    input.sha256 = std::move(digest.sha256);
    input.fileSha256 = std::move(digest.fileSha256);
    const EvidenceOrigin origin = surveyOriginOf(path, request.read);
    input.ofRun = origin.run;
    if (request.evidence) {
        noteOrigin(input.findings, path, origin, request.run);
        input.findings = noEvidenceFirst(input.findings);
    }
    return input;
}

}  // namespace rubble::io
