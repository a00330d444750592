#pragma once

#include "core/fe/site_surface.h"

namespace rubble {

/// The short name of the rooms that do not collide with it themselves.
using GroundSurface = SiteSurface;

}  // namespace rubble
