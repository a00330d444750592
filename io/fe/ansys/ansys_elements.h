#pragma once

#include <cstdint>
#include <optional>

#include "core/fe/mesh.h"

namespace rubble::io {

/// Shape of an element of Ansys MAPDL by its routine (185 for SOLID185) and its number of nodes; nothing for routines that make no
/// fragment (masses, springs, contacts, surfaces).
std::optional<ElementShape> shapeOfAnsys(std::int64_t routine, std::size_t nodes);

}  // namespace rubble::io
