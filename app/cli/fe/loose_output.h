#pragma once

#include <ostream>

#include "app/cli/frame/json_output.h"
#include "app/cli/frame/text_table.h"
#include "core/fe/loose_structure.h"

namespace rubble::cli {

/// Figures over all islands, and each of them, the heaviest first.
Json looseJson(const LooseStructure& loose, const LooseAccount& account, const FeResult& fe);

/// The same for people, with the heaviest islands.
void printLoose(std::ostream& out, const LooseStructure& loose, const LooseAccount& account);

}  // namespace rubble::cli
