#pragma once

#include "core/base/finding.h"
#include "core/fe/frame.h"
#include "core/scenario/site.h"

namespace rubble::io {

/// What speaks against the place of a case in the world, as findings: a coordinate system that is not known or has no eastings and
/// northings, a site that nothing ties to it or that lies outside the area it is made for (said where easting and northing were
/// changed for each other, or are in the unit of the system), lengths that it stretches, and what checkControlPoints() finds.
/// Throws as SitePlace.
Findings checkPlace(const Frame& frame, const Site& site);

}  // namespace rubble::io
