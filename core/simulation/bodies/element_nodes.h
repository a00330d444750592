#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/fe/mesh.h"

namespace rubble {

/// The nodes of some elements, each once, ascending.
std::vector<std::uint32_t> nodesOf(const Mesh& mesh, std::span<const ElementIndex> elements);

}  // namespace rubble
