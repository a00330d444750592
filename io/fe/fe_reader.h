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

/// Opens an FE result, recognised by content (see fe_format.h): reads mesh, times and activity, leaves nodal fields to a lazy
/// source.
/// @param path      the result, any file of a series, or a folder that holds one result; a series opens as a whole
/// @param settings  what the user says about the file; empty fields are recognised
/// @param frame     units, axes and origin of the case; what the settings say of units and axes goes before it. Applied to
///                  everything that leaves this function; contents().frame is what became of it
/// Throws WorldError (cannot be read), ParseError (is not what it should be; names file, place and remedy), UsageError (a named
/// variable does not exist; lists those that do), Cancelled.
std::shared_ptr<const FeResult> openFe(const std::string& path, const ImportSettings& settings, const Frame& frame,
                                       const Execution& execution);

/// The files that openFe() would read for a path, in their order; the path itself where it is no FE result. Throws WorldError.
/// @param alone  without the others of its series (ImportSettings::onlyThisFile)
std::vector<std::string> feFiles(const std::string& path, bool alone = false);

/// Whether files of a result have come or changed their size since it was opened: opening it again would show more, as of a
/// series that is still being written. Throws WorldError.
bool hasGrown(const FeResult& fe);

/// What has come to a result between two openings.
struct FeGrowth {
    std::int64_t states = 0;  ///< more than before; negative where the result is shorter than it was
    std::int64_t deaths = 0;  ///< more elements that are dead at the last state
    std::int64_t bytes = 0;
};
FeGrowth growthBetween(const FeResult& before, const FeResult& after);

/// What names the content of a result: the SHA-256 of its file, or of a list of all its files as sha256sum writes it (digest, two
/// blanks, name without folder, newline), hex. Throws WorldError.
std::string sha256OfFe(const std::string& path, const Execution& execution = Execution());

}  // namespace rubble::io
