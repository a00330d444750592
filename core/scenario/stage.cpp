#include "core/scenario/stage.h"

#include <array>
#include <cstddef>

namespace rubble {

std::string_view stageName(Stage stage) {
    static constexpr std::array<std::string_view, stageCount> names{"import", "components", "fragments",
                                                                    "sizing", "clusters",   "simulation"};
    return names[static_cast<std::size_t>(stage)];
}

}  // namespace rubble
