#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/execution.h"
#include "core/fe/fe_result.h"
#include "core/fe/frame.h"

namespace rubble::io {

/// What a result can be converted to.
enum class ConversionTarget { Exodus, GridSeries, Copy };

/// By the ending: .exo, .e and .ex2; .pvd; .h5. Nothing for any other.
std::optional<ConversionTarget> conversionTarget(std::string_view path);
/// "Exodus II", "series of VTU files", "Rubble copy"
std::string_view conversionName(ConversionTarget target);

/// What was written.
struct Conversion {
    ConversionTarget target = ConversionTarget::Copy;
    std::size_t states = 0;
    std::vector<std::string> files;  ///< the file, or the index and its folder
    std::uint64_t bytes = 0;
};

/// Converts a result, chosen by the ending of the path: mesh, numbers, parts, masses, deaths, places and velocities of every state;
/// one state is in memory at a time. In metres, z up, with the origin of the frame added. Nothing is at the path until all is.
/// @param replace  what is there may be replaced; a file that the result consists of never is
/// Throws UsageError (an ending of no kind, something is there already), WorldError, ParseError, Cancelled.
Conversion convertFe(const FeResult& fe, const Frame& frame, const std::string& path, bool replace, const Execution& execution);

}  // namespace rubble::io
