#pragma once

#include <string>

#include "core/base/finding.h"
#include "core/evidence/evidence_list.h"
#include "core/scenario/cloud_request.h"

namespace rubble::io {

/// What a file that is taken as evidence says of its making by this program.
struct EvidenceOrigin {
    std::string run;    ///< fingerprint of the simulated run that it shows, hex; empty: it names none
    bool ours = false;  ///< this program wrote it
    bool measured() const { return run.empty() && !ours; }
};

/// By the provenance beside a survey, else by what a GeoTIFF, GeoPackage, LAS or PLY says of itself. What cannot be read says
/// nothing.
EvidenceOrigin surveyOriginOf(const std::string& path, const CloudRequest& read);
/// By the provenance within or beside a photograph.
EvidenceOrigin photographOriginOf(const std::string& path);

/// Adds that a file taken as evidence shows a simulated run, or was made by this program. Nothing where it was measured.
/// @param held  fingerprint of the run that it is held against, hex; empty: of none, or not known
void noteOrigin(Findings& findings, const std::string& path, const EvidenceOrigin& origin, const std::string& held);

/// Says in a row of evidence that it shows a run, in place of what it is held to say.
void takeOrigin(EvidenceRow& row, const EvidenceOrigin& origin);

}  // namespace rubble::io
