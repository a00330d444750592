#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/base/execution.h"
#include "core/fe/fe_result.h"
#include "io/run/run_file.h"

namespace rubble::io {

/// Writes fragments.csv: one row per fragment, quoted as in RFC 4180, point as decimal sign, no comment lines. Places in metres, z
/// up: easting, northing and height by the control points of the case, without these with the origin of the case added. Of a run
/// that was stopped, what is not known (impact speeds, fragments not yet born) is left empty. Atomic; a sidecar
/// NAME.provenance.json says from what it was made. Throws WorldError, ParseError, Cancelled.
void exportFragments(const std::string& path, const RunReader& run, const Execution& execution);

/// The same of some fragments, ascending, in that order.
void exportFragments(const std::string& path, const RunReader& run, std::span<const FragmentId> chosen, const Execution& execution);

/// Writes D.pvd and a folder D/ of VTU files: fragments (solids with fragment_id, element_id, component, cluster_id, speed m/s) as
/// part 0 and active structure as part 1, at every FE state that the run reached and, after the last, at frames about as far apart;
/// released islands of live structure leave part 1 at the last FE state and are part 2 from then on.
/// Opens in ParaView; the numbers of component index the string field component_names. Coordinates as in exportFragments(). After
/// a cancel the series holds what was written until then.
/// Throws WorldError, ParseError, UsageError (not the FE file of the run), Cancelled.
void exportSeries(const std::string& path, const RunReader& run, const FeResult& fe, const Execution& execution);

/// Writes one VTKHDF file (version 2.0 of the format) over the instants of exportSeries(): a temporal unstructured grid, every step
/// a partition, geometry repeated from step to step and compressed. Cell arrays: fragment_id and cluster_id (-1 where a cell is no
/// fragment), element_id, component, speed (m/s, NaN where a cell is no fragment), part (0 fragments, 1 structure, 2 released);
/// field arrays component_names and part_names. VTK 9.3 and ParaView 5.12 read it with its times; older readers of the format find
/// each step as a piece. Coordinates as in exportFragments(). Atomic; with NAME.provenance.json. Throws WorldError, ParseError,
/// UsageError (not the FE file of the run), Cancelled.
void exportVtkHdf(const std::string& path, const RunReader& run, const FeResult& fe, const Execution& execution);

/// Writes the fragments as glTF 2.0 with their motion in one binary file (.glb), as Blender and web viewers open it: a node for
/// each body with the solids it carries, its places as keys (within 1 mm and 0.1 degrees of what was recorded), scale 0 before its
/// first fragment is born and after it left. Metres, y up; local coordinates, because single precision holds no map coordinates:
/// the place of the origin, and with control points turn and scale, stand in asset.extras. Colours by component. Islands of live
/// structure that bodies carry are nodes of their own, as long as their bodies are there; what still stands is not in it. Atomic;
/// with NAME.provenance.json. Throws WorldError, ParseError, UsageError (no fragments; larger than 4 GB), Cancelled.
/// @param fe  of the run; null: islands are left out
void exportGltf(const std::string& path, const RunReader& run, const FeResult* fe, const Execution& execution);

/// Writes an XDMF 3 file that names places, orientations, speeds and states of the bodies frame by frame inside the run file
/// itself, so that ParaView (its Xdmf3 readers) shows them as points without a copy. The path of the run is written relative to the
/// XDMF file. Coordinates are local. Throws WorldError, ParseError, UsageError (no frames), Cancelled.
void exportBodies(const std::string& path, const RunReader& run, const Execution& execution);

/// Provenance of a run as JSON text: inputs with SHA-256, scenario, build, settings.
std::string provenanceText(const RunReader& run);
/// The same of what was simulated or is to be. @param run  null: nothing was
std::string provenanceText(const RunOrigin& origin, const RunReader* run);
/// The provenance of a file whose places are in units of a coordinate system, with these words on its coordinates.
std::string withCoordinates(const std::string& provenance, const std::string& words);

}  // namespace rubble::io
