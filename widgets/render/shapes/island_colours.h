#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/fe/loose_structure.h"

namespace rubble::render {

/// Which of so many colours each island of loose structure has, for as long as it is one [islands]. The largest choose first; each
/// takes the colour of which there is least while it is there, so that spans which fall together look different.
std::vector<std::uint32_t> islandColours(const LooseStructure& loose, std::size_t colours);

}  // namespace rubble::render
