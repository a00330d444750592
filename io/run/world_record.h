#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/analysis/accuracy/study_store.h"

namespace rubble::io {

/// A simulated world as bytes: "rubble-world", version, origin, figures, the debris at rest and at the FE end, and a digest of all
/// that. Little-endian, doubles bit for bit.
std::string worldBytes(const WorldOrigin& origin, const SimulatedWorld& world);

/// The same back. Throws ParseError naming the file, the byte and what was expected for anything that is cut short, changed, of a
/// newer version or larger than it says.
std::pair<WorldOrigin, SimulatedWorld> worldFromBytes(std::string_view bytes, const std::string& file);

}  // namespace rubble::io
