#pragma once

#include <string>

#include "core/base/finding.h"
#include "io/site/clouds/cloud_head.h"

namespace rubble::io {

/// Whether a text names a coordinate system.
bool knowsSystem(const std::string& text);

/// Whether two texts name one coordinate system, or either names none.
bool sameSystem(const std::string& one, const std::string& other);

/// The part of a system that eastings and northings are in, as WKT. @return  empty: the text names none
std::string systemInPlan(const std::string& text);

/// Says what the numbers of a cloud mean, from its coordinate system, and what is assumed where it says nothing: findings.
/// @param asked  the system for a cloud that names none, empty: none. Throws UsageError if it is no system.
void describeUnits(const std::string& path, const std::string& asked, CloudHead& head, Findings& findings);

}  // namespace rubble::io
