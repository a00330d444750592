#include "core/evidence/clouds/cloud_volumes.h"

#include <cmath>

#include "core/base/unknown.h"

namespace rubble {

namespace {

constexpr double confidence = 1.96;

}  // namespace

CloudVolumes cloudVolumes(std::span<const CoreDistance> cells, double cell, const std::optional<double>& registrationError) {
    CloudVolumes made;
    made.cell = cell;
    made.cells = static_cast<std::int64_t>(cells.size());
    const double area = cell * cell;
    double ofFill = 0.0;
    double ofCut = 0.0;
    for (const CoreDistance& at : cells) {
        if (std::isnan(at.detection)) {
            continue;
        }
        ++made.measured;
        if (!at.significant()) {
            (at.distance > 0.0 ? made.undetectedFill : made.undetectedCut) += std::abs(at.distance) * area;
            continue;
        }
        const bool above = at.distance > 0.0;
        (above ? made.fill : made.cut) += std::abs(at.distance) * area;
        (above ? ofFill : ofCut) += at.error * at.error;
        ++(above ? made.fillCells : made.cutCells);
    }
    const auto error = [&](double variance, std::int64_t count) {
        return CloudVolumeError{confidence * area * std::sqrt(variance),
                                registrationError ? confidence * *registrationError * area * static_cast<double>(count) : unknown};
    };
    if (made.measured == 0) {
        made.fill = made.cut = made.undetectedFill = made.undetectedCut = unknown;
        made.fillError = made.cutError = made.netError = {unknown, unknown};
        return made;
    }
    made.fillError = error(ofFill, made.fillCells);
    made.cutError = error(ofCut, made.cutCells);
    made.netError = error(ofFill + ofCut, made.fillCells + made.cutCells);
    return made;
}

}  // namespace rubble
