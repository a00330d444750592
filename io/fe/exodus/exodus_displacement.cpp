#include "io/fe/exodus/exodus_displacement.h"

#include "core/base/error.h"
#include "core/base/nearest_names.h"

namespace rubble::io {

std::optional<VectorVariable> chooseDisplacement(const ExodusFile& file, const ImportSettings& settings) {
    const std::vector<std::string>& names = file.variables(ExodusEntity::Node);
    if (settings.displacement == "none") {
        return std::nullopt;
    }
    const auto found = settings.displacement.empty() ? findDisplacement(names) : findVector(names, settings.displacement);
    if (found) {
        return found;
    }
    const Message remedy{"exodus.no_displacement.remedy",
                         "Say how its components begin: --set displacement=PREFIX; displacement=none if the nodes do not move. "
                         "Nodal variables in the file: {0}",
                         {quotedList(names, 100)}};
    if (!settings.displacement.empty()) {
        throw UsageError({"exodus.unknown_displacement",
                          "{0} has no nodal variables {1}_x, {1}_y and {1}_z in any spelling",
                          {file.path(), settings.displacement}},
                         remedy);
    }
    throw ParseError({"exodus.no_displacement", "{0} has no nodal displacement under a known name", {file.path()}}, remedy);
}

void requireThreeDimensions(const ExodusFile& file) {
    if (file.dimensions() != 3) {
        throw ParseError({"exodus.dimensions",
                          "{0} has {1} dimensions; only solids, shells and beams in space make fragments",
                          {file.path(), file.dimensions()}},
                         {"exodus.dimensions.remedy", "Give a three-dimensional analysis.", {}});
    }
}

}  // namespace rubble::io
