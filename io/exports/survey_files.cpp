#include "io/exports/survey_files.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <filesystem>

#include "core/base/csv_text.h"
#include "core/evidence/no_evidence.h"
#include "io/base/files.h"
#include "io/exports/exports.h"
#include "io/exports/provenance.h"
#include "io/json/json_cursor.h"
#include "io/json/scope_json.h"
#include "io/run/acknowledgements.h"
#include "io/run/run_cautions.h"
#include "io/run/run_json.h"
#include "io/site/gdal_memory.h"
#include "io/site/gdal_session.h"
#include "io/site/input_files.h"
#include "io/site/map_place.h"

namespace rubble::io {

namespace {

constexpr double surveyNoData = -9999.0;

/// Rows from the north.
std::vector<double> northUp(const CellGrid& grid) {
    std::vector<double> values;
    values.reserve(grid.values.size());
    for (int row = grid.rows - 1; row >= 0; --row) {
        for (int column = 0; column < grid.columns; ++column) {
            const double value = grid.values[grid.index(column, row)];
            values.push_back(std::isfinite(value) ? value : surveyNoData);
        }
    }
    return values;
}

}  // namespace

SurveyRequest surveyRequest(const RunOrigin& origin, const CaseInput& stated, const std::string& terrain) {
    const std::string path = terrain.empty() ? origin.terrainPath : terrain;
    std::error_code ignored;
    const bool same = !origin.terrainPath.empty() && origin.surroundings.empty() &&
                      std::filesystem::is_regular_file(path, ignored) &&
                      digestOfInput(path, InputRole::Terrain, Execution()).is(origin.terrainSha256);
    SurveyRequest request;
    request.ground = same ? path : std::string();
    request.groundRead = origin.terrainRead;
    request.registration = stated.registration;
    request.read = stated.read;
    request.edge = stated.held == PointsHeld::Outline;
    request.run = origin.fingerprint.hex();
    return request;
}

std::string scanProvenance(const RunReader& run, const RunScan& made, const SitePlace& place) {
    nlohmann::json document = nlohmann::json::parse(provenanceText(run));
    nlohmann::json& scan = document["scan"];
    scan = {{"time_s", made.shape.time},      {"at_rest", !made.instant.has_value()}, {"moving", made.moving.moving},
            {"bodies", made.moving.bodies},   {"step_rad", made.settings.step},       {"range_m", made.settings.range},
            {"noise_m", made.settings.noise}, {"seed", made.settings.seed},           {"scanners_m", nlohmann::json::array()}};
    for (const Vec3& scanner : made.settings.scanners) {
        scan["scanners_m"].push_back(jsonVector(place.toWorld(scanner)));
    }
    return jsonText(document);
}

namespace {

/// What speaks against evidence, then the cautions of the run that is held against it at an instant.
std::vector<Caution> besideEvidence(const Findings& findings, const RunReader& run, double time) {
    std::vector<Caution> cautions = evidenceCautions(findings);
    for (Caution& caution : runCautions(standingAt(run, time))) {
        cautions.push_back(std::move(caution));
    }
    return cautions;
}

}  // namespace

std::vector<Caution> surveyCautions(const RunReader& run, const SurveyInput& survey, const SurveyComparison& made) {
    Findings all = survey.findings;
    all.append(made.findings);
    return besideEvidence(all, run, made.time);
}

std::vector<Caution> sectionCautions(const RunReader& run, const RunSection& made) {
    return besideEvidence(made.findings, run, made.time);
}

MapOrigin surveyOrigin(const RunReader& run, const SurveyComparison& made, const SurveyInput& survey, const std::string& casePath) {
    const RunOrigin& from = run.origin();
    const std::vector<Caution> known = surveyCautions(run, survey, made);
    const std::string name = std::filesystem::path(survey.path).filename().string();
    MapOrigin origin;
    origin.subject = name + " · " + mapSubject(from, casePath);
    origin.frame = survey.frame;
    origin.site = survey.site;
    const std::string crs = MapPlace(survey.frame, survey.site).name();
    const std::string fallen =
        made.settings.withFallen ? "counted, moved farther than " + exactNumber(made.settings.liveThreshold) + " m" : "left out";
    const std::string surveyed = !made.surveyShowsFallen ? "not known" : *made.surveyShowsFallen ? "shown" : "left out";
    nlohmann::json document = nlohmann::json::parse(provenanceText(run));
    document["inputs"].push_back({{"role", "survey"}, {"path", survey.path}, {"sha256", survey.sha256}});
    document["cautions"] = cautionsJson(known);
    document["survey_comparison"] = {{"survey", name},
                                     {"subject", mapSubject(from, casePath)},
                                     {"of_run", survey.ofRun.empty() ? nlohmann::json() : nlohmann::json(survey.ofRun)},
                                     {"time_s", made.time},
                                     {"cell_m", made.settings.cell},
                                     {"least_height_m", made.settings.leastHeight},
                                     {"live_structure", fallen},
                                     {"survey_live_structure", surveyed},
                                     {"registration", surveyFitName(made.settings.fit)},
                                     {"shift_m", {made.shift.by.x(), made.shift.by.y(), made.shift.by.z()}},
                                     {"level_of_detection_m", jsonNumber(made.noise.detection())},
                                     {"area_m", outlineJson(made.settings.scope.area)},
                                     {"left_out_m", outlineJson(made.settings.scope.leftOut)},
                                     {"iou", jsonNumber(made.iou)},
                                     {"crs", crs}};
    origin.provenance = jsonText(document);
    const std::string cautions = pictureCautions(known);
    origin.facts = {{"RUBBLE_CLASS", "simulated less surveyed"},
                    {"RUBBLE_TIME_S", exactNumber(made.time)},
                    {"RUBBLE_CELL_M", exactNumber(made.settings.cell)},
                    {"RUBBLE_CRS", crs},
                    {"RUBBLE_SURVEY", name},
                    {"RUBBLE_SURVEY_SHA256", survey.sha256},
                    {"RUBBLE_SURVEY_OF_RUN", survey.ofRun.empty() ? "none" : survey.ofRun},
                    {"RUBBLE_FE_SHA256", from.feSha256},
                    {"RUBBLE_SCENARIO", from.scenarioName},
                    {"RUBBLE_RUN", from.fingerprint.hex()},
                    {"RUBBLE_BUILD", from.build},
                    {"RUBBLE_TAINTED", taintOf(run).tainted() ? "yes" : "no"},
                    {"RUBBLE_CAUTIONS", cautions.empty() ? "none" : cautions},
                    {"RUBBLE_LIVE_STRUCTURE", fallen},
                    {"RUBBLE_SURVEY_LIVE_STRUCTURE", surveyed},
                    {"RUBBLE_REGISTRATION", std::string(surveyFitName(made.settings.fit))},
                    {"RUBBLE_SCOPE", made.settings.scope.whole() ? "all that was surveyed" : "an area of interest"}};
    return origin;
}

void writeSurveyTiff(const std::string& path, const SurveyComparison& made, const MapOrigin& origin, const Execution& execution) {
    execution.check();
    const MapPlace place(origin.frame, origin.site);
    const CellGrid& grid = made.difference;
    const GdalMemoryFile memory(".tif");
    {
        const GdalSession session;
        GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
        const std::array<const char*, 4> options{"COMPRESS=DEFLATE", "PREDICTOR=3", "INTERLEAVE=BAND", nullptr};
        GDALDatasetUniquePtr file(
            driver->Create(memory.name().c_str(), grid.columns, grid.rows, 3, GDT_Float64, const_cast<char**>(options.data())));
        if (!file) {
            failGdal(path);
        }
        std::array<double, 6> transform = place.pixels(grid.cell * Eigen::Vector2d(grid.low.i, grid.low.j + grid.rows), grid.cell);
        file->SetGeoTransform(transform.data());
        file->SetSpatialRef(&place.system());
        for (const auto& [key, value] : origin.facts) {
            file->SetMetadataItem(key.c_str(), value.c_str());
        }
        const std::array<std::pair<const char*, const CellGrid*>, 3> bands{
            {{"difference", &made.difference}, {"surveyed", &made.surveyedCells}, {"simulated", &made.simulatedCells}}};
        for (std::size_t b = 0; b < bands.size(); ++b) {
            GDALRasterBand& band = *file->GetRasterBand(static_cast<int>(b + 1));
            band.SetDescription(bands[b].first);
            band.SetUnitType(made.isFootprint && b < 2 ? "" : "m");
            band.SetNoDataValue(surveyNoData);
            std::vector<double> values = northUp(*bands[b].second);
            if (band.RasterIO(GF_Write, 0, 0, grid.columns, grid.rows, values.data(), grid.columns, grid.rows, GDT_Float64, 0, 0,
                              nullptr) != CE_None) {
                failGdal(path);
            }
        }
    }
    memory.save(path);
    writeProvenance(path, withCoordinates(origin.provenance, place.words()));
}

std::string sectionFoot(const RunReader& run, const RunSection& made) {
    constexpr std::size_t figures = 16;  // tell one digest from another
    std::string line = footLine(run.origin());
    for (const RunSection::File& file : made.files) {
        line += ", points " + file.sha256.substr(0, figures);
    }
    return line;
}

std::string distanceProvenance(const RunReader& run, const RunDistance& made, const std::string& sha256) {
    const CloudComparison& compared = made.compared;
    const std::optional<double>& registration = compared.settings.registrationError;
    nlohmann::json document = nlohmann::json::parse(provenanceText(run));
    const std::string& cloud = compared.first.path;
    document["inputs"].push_back({{"role", "survey"}, {"path", cloud}, {"sha256", sha256}});
    document["cloud_distances"] = {{"cloud", std::filesystem::path(cloud).filename().string()},
                                   {"time_s", made.time},
                                   {"normal_scale_m", compared.settings.normalRadius},
                                   {"projection_scale_m", compared.settings.projectionRadius},
                                   {"depth_m", compared.settings.depth},
                                   {"registration_error_m", registration ? nlohmann::json(*registration) : nlohmann::json()}};
    document["cautions"] = cautionsJson(besideEvidence(compared.findings, run, made.time));
    return jsonText(document);
}

std::string sectionProvenance(const RunReader& run, const RunSection& made, const SitePlace& place) {
    const SectionLine& line = made.section.line;
    const Eigen::Vector2d from = place.planToWorld(line.from);
    const Eigen::Vector2d to = place.planToWorld(line.to);
    nlohmann::json document = nlohmann::json::parse(provenanceText(run));
    document["section"] = {
        {"time_s", made.time}, {"line_m", {from.x(), from.y(), to.x(), to.y()}}, {"width_m", line.width}, {"step_m", line.step}};
    for (const RunSection::File& file : made.files) {
        document["inputs"].push_back({{"role", "survey"}, {"path", file.path}, {"sha256", file.sha256}});
    }
    document["cautions"] = cautionsJson(sectionCautions(run, made));
    return jsonText(document);
}

}  // namespace rubble::io
