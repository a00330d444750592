#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/mesh.h"
#include "io/fe/series/byte_window.h"
#include "io/fe/straight_edges.h"

namespace rubble::io {

/// What a coded database of Ansys MAPDL (.cdb) holds of a model.
struct CdbModel {
    Mesh mesh;                   ///< in the file's units; a part for each material
    std::vector<double> flags;   ///< birth/death field of each element
    std::optional<double> time;  ///< s, where a command or a comment says it
    Findings findings;
    StraightEdges straight;  ///< what straight edges cost, not yet among the findings
};

/// Reads one. Layout after the MAPDL programmer's reference, "Coded database files". Throws WorldError, ParseError with the byte.
CdbModel readCdb(const std::string& path);

/// True if a file holds the blocks of a coded database. @param head  its first bytes
bool beginsAsCdb(const std::string& head);

/// A kill or a revival of a macro or solution log.
struct KillEvent {
    std::int64_t element = 0;
    double time = 0.0;  ///< s
    bool active = false;
};

/// The commands EKILL and EALIVE of a macro with the times of their load steps (TIME, or a comment "time T"), in their order. Kills
/// without a number (ALL, components) are counted. Throws WorldError.
std::vector<KillEvent> readKills(const std::string& path, std::vector<double>& times, Findings& findings);

}  // namespace rubble::io
