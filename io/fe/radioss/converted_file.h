#pragma once

#include <string>

#include "io/fe/radioss/anim_file.h"

namespace rubble::io {

/// Reads one legacy VTK file of anim_to_vtk as if it were the animation file. Names of parts, masses and the difference between
/// deleted and rigid are lost in it. Throws ParseError naming file, byte, what was expected and found; WorldError.
AnimState readConvertedFile(const std::string& path, AnimWanted wanted);

}  // namespace rubble::io
