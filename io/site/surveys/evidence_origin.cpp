#include "io/site/surveys/evidence_origin.h"

#include <gdal_priv.h>

#include <array>
#include <memory>
#include <string_view>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/json/run_behind.h"
#include "io/site/clouds/point_cloud.h"
#include "io/site/gdal_session.h"

namespace rubble::io {

namespace {

/// What a map of ours says of itself under any name; of an ensemble it names no run.
EvidenceOrigin mapOriginOf(const std::string& path) {
    const GdalSession session;
    constexpr std::array formats{"GTiff", "GPKG", static_cast<const char*>(nullptr)};
    GDALDatasetUniquePtr file(GDALDataset::FromHandle(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_VECTOR | GDAL_OF_READONLY, formats.data(), nullptr, nullptr)));
    const auto says = [&file](const char* key) -> std::string_view {
        const char* value = file ? file->GetMetadataItem(key) : nullptr;
        return value != nullptr ? value : "";
    };
    return {fingerprintOf(says("RUBBLE_RUN")), !says("RUBBLE_CLASS").empty()};
}

}  // namespace

EvidenceOrigin surveyOriginOf(const std::string& path, const CloudRequest& read) {
    EvidenceOrigin origin;
    origin.run = runBehind(path);
    if (origin.run.empty()) {
        origin = mapOriginOf(path);
    }
    const bool may = hasEnding(path, ".las") || hasEnding(path, ".laz") || hasEnding(path, ".ply") || beginsAsCloud(path);
    if (!origin.measured() || !may) {
        return origin;
    }
    try {
        const std::unique_ptr<PointCloud> cloud = openCloud(path, read);
        origin.run = cloud->head().run;
        origin.ours = cloud->head().ours;
    } catch (const Error&) {
        origin.ours = false;  // what is wrong with it is said where it is read
    }
    return origin;
}

EvidenceOrigin photographOriginOf(const std::string& path) {
    return {runWithin(path), false};
}

void noteOrigin(Findings& findings, const std::string& path, const EvidenceOrigin& origin, const std::string& held) {
    noteRunBehind(findings, path, origin.run, held);
    if (origin.run.empty() && origin.ours) {
        findings.add({"evidence.ours", "The evidence was written by this program, without a word of the run that it shows", {}},
                     {"evidence.ours.remedy",
                      "Take it out of the evidence, unless all of its points were measured: a scan of a run is no evidence.",
                      {}},
                     path);
    }
}

void takeOrigin(EvidenceRow& row, const EvidenceOrigin& origin) {
    row.run = origin.run;
    row.ours = origin.ours || !origin.run.empty();
    if (!origin.run.empty()) {
        row.says = {"evidence.shows_run", "a simulated run: no evidence", {}};
    } else if (origin.ours) {
        row.says = {"evidence.shows_ours", "what this program wrote: evidence only if it was measured", {}};
    }
}

}  // namespace rubble::io
