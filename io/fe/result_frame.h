#pragma once

#include "core/base/execution.h"
#include "core/fe/fe_result.h"
#include "core/fe/frame.h"
#include "core/scenario/scenario.h"

namespace rubble::io {

/// Brings what a reader made, in units and axes of its file, into SI and the local frame of a case: the one place where units are
/// converted. Decides units and up axis (settings, else the frame; `auto`: by evidence), and moves structures that lie farther than
/// 10 km from the origin of a frame that has none to a local origin of whole hundreds of metres. Fills in `frame`, `units` and
/// `unitsFrom`; counts findings where units cannot be right or a deck says others.
/// Throws UsageError for a frame that makes no sense; as the source does where `auto` looks for free fall; Cancelled.
void bringIntoFrame(FeResult::Contents& contents, const ImportSettings& settings, const Frame& frame, const Execution& execution);

}  // namespace rubble::io
