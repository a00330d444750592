#pragma once

#include "core/fe/site_surface.h"

namespace rubble {

/// Level ground at height zero.
inline const SiteSurface levelSite{};

}  // namespace rubble
