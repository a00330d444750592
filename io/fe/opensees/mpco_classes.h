#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/fe/mesh.h"

namespace rubble::io {

/// "56-Brick[400:0]", the name of a table of elements: class tag, class name, rule of integration.
struct MpcoClass {
    std::int64_t tag = 0;
    std::string name;  ///< "Brick"; the whole text where it is spelt otherwise
};
MpcoClass mpcoClass(const std::string& table);

/// True for classes that OpenSees keeps as elements and that are no structure: springs without length, contacts, loaded faces,
/// links, boundaries that absorb waves, embedded nodes.
bool isNoStructure(const std::string& className);

/// Shape of an element by the geometry that the recorder names (attribute GEOMETRY), by its class, by the number and the places of
/// its nodes; nothing where none of them tells. @param nodes  places of all nodes  @param geometry  0: not said
std::optional<ElementShape> mpcoShape(std::int64_t geometry, const std::string& className, std::span<const Vec3> nodes);

}  // namespace rubble::io
