#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/fe/fe_result.h"
#include "core/fe/frame.h"
#include "core/scenario/scenario.h"

namespace rubble::io {

/// Opens an FE result as openFe() does, through a copy in a cache folder: where there is one of the same files, settings and frame,
/// only its tables are read; else the result is opened itself and the copy made. What comes out is the same bit by bit, with the
/// same fingerprint. A copy holds as long as all files of the series have the size and the times that they had, or the SHA-256; a
/// damaged one is made anew, which is a finding; a state of it that turns out to be damaged is read from the result. Two programs
/// may do so at once.
/// @param folder  see cacheFolder(); made when it is needed
/// Throws as openFe() does. A folder without room or rights is a finding.
std::shared_ptr<const FeResult> openFeCached(const std::string& path, const ImportSettings& settings, const Frame& frame,
                                             const Execution& execution, const std::string& folder);

/// What a cache folder holds of one kind, or of one result.
struct CacheEntry {
    std::string kind;  ///< "fe", "worlds", "islands", "checkpoints", "costs", "points" or "calibration"
    std::string of;    ///< the result that a copy was made of; empty for what studies keep
    std::size_t files = 0;
    std::uint64_t bytes = 0;
};

/// Copies of results, largest first, then what studies keep (StudyFiles). Never throws.
std::vector<CacheEntry> cacheEntries(const std::string& folder);

/// Removes what the cache folder holds of these kinds, all if none is named, and nothing else that may lie there. Gives what was
/// removed. Throws WorldError.
std::vector<CacheEntry> clearCache(const std::string& folder, const std::vector<std::string>& kinds);

/// The kinds in the order of the list.
const std::vector<std::string>& cacheKinds();

}  // namespace rubble::io
