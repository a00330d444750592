#pragma once

#include <QString>

#include "core/evidence/clouds/cloud_volumes.h"
#include "io/site/clouds/run_distance.h"

namespace rubble {

/// "Level of detection 0.05 m in the middle (95 %).", and whether the registration error is part of it.
QString detectionWords(double detection, bool registered);

/// Fill, cut and net with their errors, what lies below the level of detection, and how many cells were measured.
/// @param cube  m3 in a cube of the unit that they are in
QString volumeWords(const CloudVolumes& volumes, double cube);

/// From where the points of a cloud were seen that was held against a run.
QString sightWords(const io::RunDistance& made);

/// How many places of two clouds differ, the level of detection there, and their volumes.
QString pairWords(const io::CloudComparison& made);

}  // namespace rubble
