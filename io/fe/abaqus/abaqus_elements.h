#pragma once

#include <optional>
#include <string_view>

#include "core/fe/mesh.h"

namespace rubble::io {

/// Shape of an element of Abaqus or CalculiX by the name of its type ("C3D8R"); nothing for types that make no fragment (springs,
/// masses, contacts, rigid surfaces) and for flat analyses.
std::optional<ElementShape> shapeOfAbaqus(std::string_view type);

/// True for types of flat and axisymmetric analyses ("CPE4").
bool isFlatAbaqus(std::string_view type);

}  // namespace rubble::io
