#pragma once

#include <memory>
#include <string>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/fe/frame.h"
#include "core/fe/orthophoto.h"
#include "core/scenario/site.h"
#include "io/site/site_place.h"

namespace rubble::io {

/// Reads an orthophoto in a window into the local frame, rows along x; at most 2,048 pixels on a side, coarser ones put
/// together by their mean. What the file does not cover, or masks, is transparent.
/// @param findings  what is assumed of its colours and its place is added
/// Throws WorldError, ParseError (no picture, elsewhere, degrees in a case without a coordinate system), UsageError, Cancelled.
std::shared_ptr<const Orthophoto> readOrthophoto(const std::string& path, const Frame& frame, const Site& site,
                                                 const SiteWindow& window, const Execution& execution, Findings& findings);

}  // namespace rubble::io
