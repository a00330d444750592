#pragma once

#include "core/base/finding.h"
#include "core/fe/mesh.h"
#include "io/fe/series/byte_window.h"

namespace rubble::io {

/// Reads connectivity (507), coordinates (508) and sets (513) from where the window stands to the next increment. An element
/// belongs to the smallest set that holds it. Throws ParseError with the byte.
Mesh readMarcMesh(ByteWindow& window, Findings& findings);

}  // namespace rubble::io
