#pragma once

#include <string>
#include <vector>

#include "core/evidence/cautions.h"
#include "core/evidence/surveys/survey_comparison.h"
#include "core/scenario/case.h"
#include "io/exports/map_files.h"
#include "io/site/clouds/run_distance.h"
#include "io/site/clouds/run_scan.h"
#include "io/site/survey_file.h"
#include "io/site/surveys/run_section.h"

namespace rubble::io {

/// A survey against a run: as the case states it, above the terrain that the run fell on. Heights are taken above the nodes of the
/// terrain if the run had none, if surroundings raised it, or if the file is not that one any more.
/// @param terrain  where the file is now; empty: where the run says
SurveyRequest surveyRequest(const RunOrigin& origin, const CaseInput& stated, const std::string& terrain = {});

/// What must be known beside a comparison: what speaks against the survey as evidence, then the cautions of the run.
std::vector<Caution> surveyCautions(const RunReader& run, const SurveyInput& survey, const SurveyComparison& made);

/// What a comparison with a survey was made from, as every file of it says. @param casePath  empty: no case is known
MapOrigin surveyOrigin(const RunReader& run, const SurveyComparison& made, const SurveyInput& survey, const std::string& casePath);

/// What a scan of a run was made from, as every file of it says: with the instant that it shows and where its scanners stood.
std::string scanProvenance(const RunReader& run, const RunScan& made, const SitePlace& place);

/// Writes a comparison as GeoTIFF with the bands difference, surveyed and simulated [m; of a footprint shares of cells], no-data
/// value -9999, rows from the north, the coordinate system of the case. Atomic, with NAME.provenance.json.
/// Throws WorldError, UsageError, Cancelled.
void writeSurveyTiff(const std::string& path, const SurveyComparison& made, const MapOrigin& origin, const Execution& execution);

/// Provenance of distances between a cloud and a run: that of the run, with the cloud, the instant, and what speaks against the
/// cloud as evidence, as JSON. @param sha256  of the cloud
std::string distanceProvenance(const RunReader& run, const RunDistance& made, const std::string& sha256);

/// What must be known beside a section: which of its points speak against themselves as evidence, then the cautions of the run.
std::vector<Caution> sectionCautions(const RunReader& run, const RunSection& made);

/// What stands at the foot of a section: as footLine(), and the first figures of the files of points.
std::string sectionFoot(const RunReader& run, const RunSection& made);

/// Provenance of the picture of a section: that of its run, with what was cut, where, and the files that were measured, as JSON.
std::string sectionProvenance(const RunReader& run, const RunSection& made, const SitePlace& place);

}  // namespace rubble::io
