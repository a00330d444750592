#pragma once

#include "app/cli/frame/command.h"

namespace rubble::cli {

// Rows of the command table: studies of many members of one collapse.
Command ensembleCommand();
Command compareCommand();

}  // namespace rubble::cli
