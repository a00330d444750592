#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/evidence/clouds/site_scan.h"
#include "core/evidence/scanned_site.h"
#include "io/site/clouds/run_distance.h"
#include "io/site/site_place.h"

namespace rubble::io {

/// What a point of a scan may lie on: the kinds of SiteThing.
inline constexpr std::size_t scannedThings = 5;

/// A scan of a run, and what it was made with.
struct RunScan {
    ScanSettings settings;  ///< m, local
    SiteScan scan;
    SiteShape shape;
    std::optional<double> instant = std::nullopt;  ///< s, on the clock of the FE file, that was asked for; unset: the end
    std::string run = {};                          ///< fingerprint of the run, hex
    MovingBodies moving = {};                      ///< at that instant
    SightedDebris debris;
    std::array<std::uint64_t, scannedThings> counts{};  ///< points by what they lie on
    Findings findings;
};

/// Scans the site of a run with its ground. The instant is left open. @param settings  scanners in m, local; without any, four
/// stand around the debris, 1.8 m above the ground. Throws UsageError (nothing is seen, and as scanSite()), Cancelled.
RunScan scanRun(ScannedSite site, ScanSettings settings, const Execution& execution);

/// Whether a path ends as that of a scan that can be written: .las, .ply or .csv.
bool namesScan(const std::string& path);

/// Writes a scan in the system of the case with the class of each point; a LAS says where its scanners stood, a LAS and a PLY also
/// which instant of which run they show. Throws WorldError.
void writeScan(const std::string& path, const RunScan& made, const SitePlace& place);

/// That a table does not keep which instant a scan shows; nothing of a scan at rest, a LAS or a PLY.
void tellUnsaidInstant(const std::string& path, const RunScan& made, Findings& findings);

/// s, on the clock of the FE file: the instant that a scan of ours says it shows. Unset: it says none, or is no cloud.
std::optional<double> scannedInstant(const std::string& path, const CloudRequest& read);

}  // namespace rubble::io
