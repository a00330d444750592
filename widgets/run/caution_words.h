#pragma once

#include <QString>
#include <vector>

#include "core/evidence/cautions.h"

namespace rubble::widgets {

/// A passed limit's grade in the language of the window.
QString gradeWords(HealthGrade grade);

/// What pictures and panels show of cautions, in one line; empty: none.
QString cautionWords(const std::vector<Caution>& cautions);

}  // namespace rubble::widgets
