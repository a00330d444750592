#include "core/clusters/clustering.h"

#include "core/clusters/axis_grouping.h"

namespace rubble {

std::vector<std::uint32_t> groupAlongAxis(std::span<const double> low, std::span<const double> high, std::span<const double> centre,
                                          std::span<const std::int64_t> elementId, double size) {
    std::vector<std::uint32_t> group(low.size());
    AxisGrouping().group(orderAlongAxis(low, high, centre, elementId), size, group);
    return group;
}

}  // namespace rubble
