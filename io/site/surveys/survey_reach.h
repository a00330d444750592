#pragma once

#include <optional>
#include <string>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/fe/frame.h"
#include "core/scenario/registration.h"
#include "core/scenario/site.h"

namespace rubble::io {

/// Says of a survey that it lies elsewhere than its site, before anything is compared with it. An outline or a cloud is farther
/// from the structure than a site is read ("survey.far"); heights cover none of it, or corners have no place there, in the words of
/// their readers. Of a cloud only its head counts. Where that does not say where it lies, its first points do, if they are
/// kilometres away.
/// @param structure  m, local, at rest
/// Throws as readOutline(), readHeights() and CloudPlace for everything else that is wrong with it.
Findings checkSurveyReach(const std::string& path, const std::optional<Registration>& placed, const Frame& frame, const Site& site,
                          const Aabb& structure, const Execution& execution);

}  // namespace rubble::io
