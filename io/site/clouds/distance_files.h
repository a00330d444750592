#pragma once

#include <array>
#include <ostream>
#include <string>

#include "io/site/clouds/cloud_comparison.h"

namespace rubble::io {

/// Writes the core points as a cloud with what was measured at each: distance, level of detection, roughness, points, whether the
/// distance is significant (0, 1; 255: not known). What is not known is not a number. Significant distances are coloured, red
/// where the second cloud lies above and blue below, as strong as the greatest of all; all others are grey. LAS 1.4 (format 7,
/// extra bytes, the system of the first cloud) or binary PLY, by the ending. Throws WorldError.
void writeDistanceCloud(const std::string& path, const CloudComparison& made);

/// Why a core has no distance, as tables name it.
inline constexpr std::array<const char*, coreStateCount> coreStateNames{"measured", "no_normal", "no_first", "no_second",
                                                                        "no_point"};

/// Writes a row for each core point, with all that was measured there; what is not known is an empty field.
void writeDistances(std::ostream& out, const CloudComparison& made);

/// Whether a path ends as that of distances that can be written: .las, .ply or .csv.
bool namesDistances(const std::string& path);

/// Writes one or the other, by the ending. Throws WorldError.
void writeDistanceFile(const std::string& path, const CloudComparison& made);

}  // namespace rubble::io
