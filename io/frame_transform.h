#pragma once

#include "core/fe/frame_transform.h"

namespace rubble::io {

using rubble::FrameTransform;

}  // namespace rubble::io
