#pragma once

#include <ostream>

#include "core/analysis/accuracy/calibration.h"

namespace rubble {

/// The points of a calibration, one row each, in the columns of rubble-cli calibrate --csv: RFC 4180, one heading row of keys,
/// numbers to the last bit, an empty field where nothing was drawn.
void writeCalibrationCsv(const Calibration& calibration, std::ostream& out);

}  // namespace rubble
