#pragma once

#include <memory>
#include <string>

#include "core/base/execution.h"
#include "core/fe/fe_result.h"
#include "io/run_file.h"

namespace rubble::io {

/// Writes fragments.csv (columns of the manual): one row per fragment, RFC 4180, point as decimal sign, no comment lines. Atomic; a
/// sidecar NAME.provenance.json says from what it was made. Throws WorldError.
void exportFragments(const std::string& path, const RunReader& run, const Execution& execution);

/// Writes D.pvd and a folder D/ of VTU files: fragments (current solids with fragment_id, element_id, component, cluster_id, speed)
/// as part 0 and active structure as part 1, at every FE state and at the frames after the last. Opens in ParaView.
void exportSeries(const std::string& path, const RunReader& run, const FeResult& fe, const Execution& execution);

/// Provenance of a run as JSON text: inputs with SHA-256, scenario, build, settings.
std::string provenanceText(const RunReader& run);

}  // namespace rubble::io
