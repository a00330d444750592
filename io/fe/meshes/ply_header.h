#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/fe/meshes/mesh_lines.h"
#include "io/fe/vtk/stored_numbers.h"

namespace rubble::io {

/// A property of an element of a PLY: a number, or a list with its length before it.
struct PlyProperty {
    std::string name;
    NumberType type;  ///< of the number, or of those of the list
    bool list = false;
    NumberType length;  ///< of a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

/// What the head of a PLY says of the numbers behind it.
struct PlyHeader {
    bool text = false;
    bool bigEndian = false;
    std::vector<PlyElement> elements;
    std::vector<std::string> comments;  ///< in their order, without the word before them
};

/// Whether a file is a PLY of points alone: without faces and strips of them. False for what is no PLY that can be read.
bool isPlyOfPoints(const std::string& path);

/// Reads the head of a PLY, so that the lines stand behind it. Throws ParseError naming the line that cannot be read.
PlyHeader readPlyHeader(MeshLines& lines, const std::string& path);

}  // namespace rubble::io
