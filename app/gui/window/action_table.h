#pragma once

#include "app/gui/stage/actions.h"

namespace rubble {

// The rows of the menus; actionTable() lists them in this order.
std::span<const ActionRow> caseActions();        ///< Case, Edit
std::span<const ActionRow> viewActions();        ///< View, Camera, Look
std::span<const ActionRow> selectActions();      ///< Select
std::span<const ActionRow> simulationActions();  ///< Simulation
std::span<const ActionRow> evidenceActions();    ///< Evidence
std::span<const ActionRow> exportActions();      ///< Export
std::span<const ActionRow> helpActions();        ///< Help

}  // namespace rubble
