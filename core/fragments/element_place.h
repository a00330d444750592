#pragma once

#include <cstddef>
#include <string>

#include "core/base/ids.h"
#include "core/fe/components.h"
#include "core/fe/mesh.h"

namespace rubble {

/// "element 17,233 (deck 1) at state 12": the user's element number, its component and the 0-based state, as examples of findings.
std::string elementPlace(const Mesh& mesh, const Components& components, ElementIndex element, std::size_t state);

}  // namespace rubble
