#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/evidence/site_section.h"
#include "core/scenario/cloud_request.h"

namespace rubble::io {

/// A section through what a run leaves on a site.
struct RunSection {
    /// A file that was measured, beside the simulated surface.
    struct File {
        std::string path;
        std::string sha256;
    };
    SiteSection section;
    double time = 0.0;  ///< s, of what is cut
    double zero = 0.0;  ///< m, height of the local zero in the system of the case
    std::vector<File> files{};
    Findings findings;  ///< terrain taken coarser, points without a surface or beside the line
};

/// Names a file of points beside a section, and notes where it shows a run rather than what fell.
/// @param read  how a cloud or a table is read
/// @param cut  fingerprint of the run that is cut, hex; empty: not known
void addMeasuredFile(RunSection& made, const RunSection::File& file, const CloudRequest& read, const std::string& cut);

/// The line along measured points, as rubble::lineAlong() finds it. Points farther from it than half its width are counted.
SectionLine lineAlongPoints(std::span<const MeasuredSet> measured, const SectionLine& line, Findings& findings);

/// Adds the ground about a line to a site and cuts both. @param site  without ground
/// Throws as siteSection().
RunSection cutRun(SiteShape site, const SiteSurface& ground, const SectionLine& line, std::span<const MeasuredSet> measured,
                  const Execution& execution);

}  // namespace rubble::io
