#pragma once

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/session.h"
#include "core/base/finding.h"
#include "core/scenario/case.h"

namespace rubble::cli {

/// Options that change what a case says of its evidence.
std::vector<Option> evidenceChangeOptions();

/// Whether any of them was given.
bool changesEvidence(const Arguments& arguments);

/// Changes the case as asked for. What is assumed on the way, and what speaks against it, are findings.
/// Throws UsageError (options that do not go together, pairs that leave the place open), and as reading and fitting do.
void changeEvidence(Case& theCase, const Arguments& arguments, Session& session, Findings& findings);

}  // namespace rubble::cli
