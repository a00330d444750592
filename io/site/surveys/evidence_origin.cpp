#include "io/site/surveys/evidence_origin.h"

#include <memory>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/json/run_behind.h"
#include "io/site/clouds/point_cloud.h"

namespace rubble::io {

EvidenceOrigin surveyOriginOf(const std::string& path, const CloudRequest& read) {
    EvidenceOrigin origin;
    origin.run = runBehind(path);
    const bool may = hasEnding(path, ".las") || hasEnding(path, ".laz") || hasEnding(path, ".ply") || beginsAsCloud(path);
    if (!origin.run.empty() || !may) {
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
