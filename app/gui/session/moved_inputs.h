#pragma once

#include <QString>
#include <vector>

#include "core/scenario/case.h"

namespace rubble {

/// The same files, with their paths relative to another case file.
std::vector<CaseInput> movedInputs(std::vector<CaseInput> inputs, const QString& from, const QString& to);

/// The case with its inputs relative to another place, so that it can be saved there.
Case movedCase(const Case& theCase, const QString& from, const QString& to);

}  // namespace rubble
