#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/evidence/ensembles/cause_comparison.h"
#include "core/fe/frame.h"
#include "core/fe/site_surface.h"
#include "core/scenario/case.h"

namespace rubble::io {

/// A file that hypotheses are held against, and what it holds.
struct EvidenceFile {
    enum class Kind {
        Footprint,  ///< polygons of the area that debris covered
        Heights,    ///< raster of the height of the debris above the ground
        Surface,    ///< raster of the surface with the debris on it
        Survey,     ///< a survey of the case: polygons, or heights of the surface, as the file has them
    };
    Kind kind = Kind::Footprint;
    std::string path;
    friend bool operator==(const EvidenceFile&, const EvidenceFile&) = default;
};
/// "footprint", "height", "surface", "survey"
std::string_view evidenceKeyword(EvidenceFile::Kind kind);

/// The site that evidence is laid on.
struct EvidenceSite {
    Frame frame;
    Site site;
    SiteSurface ground;
    std::string groundFile = {};   ///< that the ground was read from; empty: heights are taken above its nodes
    CloudRequest groundRead = {};  ///< of a ground that is a point cloud
};

/// Reads a file of evidence, as a survey is read, onto the cells of the ensembles. What is assumed or left out is added to the
/// findings. Throws as readSurvey() and surfaceEvidence(), UsageError (a survey of an instant of the collapse).
/// @param stated  what the case says of it, with the scope that counts
SurfaceEvidence readEvidence(const EvidenceFile& file, const EvidenceSite& site, const CaseInput& stated,
                             const SurfaceSettings& settings, Findings& findings, const Execution& execution);

/// The survey of a case that a file is; null: it is none of them.
const CaseInput* surveyOfFile(const Case& theCase, const std::string& casePath, const std::string& file);

/// s, on the clock of the FE file: which instant of a run a scan of ours says it shows, as a finding too; unset: it says none.
std::optional<double> instantOfScan(const std::string& file, Findings& findings);

/// What a case says of a file, with the scope that counts when it was taken; of a file that is none of its surveys all counts, as
/// it lies, at the instant that a scan of ours says. Throws UsageError for what shows no debris.
/// @param given  in place of the scope that the case keeps, unless it is everything
CaseInput statedOfFile(const Case& theCase, const std::string& casePath, const std::string& file, const SurveyScope& given,
                       Findings& findings);

/// The photographs of a case that say where debris lay at rest and whose camera is known, in their order; every other one is a
/// finding. Throws Cancelled.
std::vector<PhotoEvidence> photographsAsEvidence(const Case& theCase, Findings& findings, const Execution& execution);

}  // namespace rubble::io
