#pragma once

#include <optional>
#include <vector>

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/json_output.h"
#include "core/evidence/scanned_site.h"
#include "core/pipeline/pipeline.h"
#include "io/run/run_file.h"
#include "io/site/clouds/run_distance.h"

namespace rubble::cli {

/// The site of a run at an instant; unset: at its end. @param liveThreshold  m, farther than this live structure has fallen
/// Throws as siteOfRun().
ScannedSite scannedSite(const io::RunReader& run, const Inputs& inputs, std::optional<double> time, double liveThreshold,
                        const Execution& execution);

/// The option --scanner.
Option scannerOption(std::string_view help);
/// The places that it names, as easting, northing and height, m. Throws UsageError.
std::vector<Vec3> scannersFrom(const Arguments& arguments);
/// The instant of --time; unset: the end. Throws UsageError.
std::optional<double> instantFrom(const Arguments& arguments);

Json sightedJson(const io::SightedDebris& debris);
/// "120 of 150 fragments seen, 12.5 m3; 30 not seen, 4.1 m3"
std::string sightedText(const io::SightedDebris& debris);

}  // namespace rubble::cli
