#pragma once

#include <string_view>

namespace rubble {

/// Stages of the pipeline in the order data flows. A parameter belongs to the first stage that reads it; changing it makes that
/// stage and all later ones stale.
enum class Stage { Import, Components, Fragments, Sizing, Clusters, Simulation };
inline constexpr int stageCount = 6;

/// "import", "components", ...
std::string_view stageName(Stage stage);

}  // namespace rubble
