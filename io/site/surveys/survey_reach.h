#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/fe/frame.h"
#include "core/scenario/cloud_request.h"
#include "core/scenario/registration.h"
#include "core/scenario/site.h"

namespace rubble::io {

/// Says of a survey that it lies elsewhere than its site, before anything is compared with it. An outline or a cloud is farther
/// from the structure than a site is read ("survey.far"); heights cover none of it, or corners have no place there, in the words of
/// their readers. Of a cloud only its head counts. Where that does not say where it lies, its first points do, if they are
/// kilometres away.
/// @param structure  m, local, at rest; @param read  how a cloud or a table is read
/// Throws as readOutline(), readHeights() and CloudPlace for everything else that is wrong with it.
Findings checkSurveyReach(const std::string& path, const std::optional<Registration>& placed, const Frame& frame, const Site& site,
                          const Aabb& structure, const Execution& execution, const CloudRequest& read = {});

/// Points of a cloud that is looked through as soon as it is added.
inline constexpr std::uint64_t lookedThroughMost = 5'000'000;

/// What is odd in the points of a cloud, such as colours of 8 bits, coarse coordinates, or vegetation alone, and how many were left
/// out. Nothing of a file that is no cloud, or of one with more points than are looked through; that is told where it is compared.
/// Throws as openCloud() and summariseCloud().
Findings lookThroughCloud(const std::string& path, const CloudRequest& read, const Execution& execution);

}  // namespace rubble::io
