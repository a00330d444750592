#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/command.h"
#include "app/cli/frame/json_output.h"
#include "core/fe/frame.h"
#include "core/scenario/registration.h"
#include "core/scenario/site.h"

namespace rubble::cli {

/// The option --case of what a run is held against.
Option evidenceCaseOption();
/// The case that says how evidence lies: the operand if it is one, else that of --case; empty: none.
std::string caseOfEvidence(const Arguments& arguments);

/// The option --pairs-error of what is placed by pairs. @param unit  of lengths, as help names it
Option pairsErrorOption(std::string_view unit);
std::optional<double> pairsErrorFrom(const Arguments& arguments);

/// How a survey was moved and how well that is known; null: it lies as its coordinates say.
Json registrationJson(const std::optional<Registration>& registration);
/// "metres, z up, origin of the frame added; then moved by 0.3 m and turned by 0.1 degrees by 5 pairs, ..."
std::string placedText(const Frame& frame, const Site& site, const std::optional<Registration>& registration);

}  // namespace rubble::cli
