#pragma once

#include "core/base/unknown.h"
#include "core/validation/validation_record.h"

namespace rubble::scenes {

/// A set of two variants as a validation leaves it, with numbers that are easy to find again.
inline ValidationRecord tossRecord() {
    VariantRecord blind;
    blind.name = "blind";
    blind.words = "by the table";
    blind.parameters = {{"friction", "0.6", "assumed: concrete"}};
    blind.bodies = 16;
    blind.falls = 32;
    blind.moving = 1;
    blind.left = 2;
    blind.stepRate = 240.0;
    blind.stepRateReason = "single bodies";
    QuantityRecord runOut{"run_out_m[Plate]", "run-out, Plate", "m", {}};
    runOut.comparison.measured = {16, 0.5, 0.05};
    runOut.comparison.simulated = {30, 0.25, 0.04};
    runOut.comparison.lost = 2;
    runOut.comparison.error = {-0.25, -0.375, -0.125};
    runOut.comparison.uncertainty = 0.0625;
    runOut.comparison.scatterRatio = {0.8, 0.6, 1.1};
    runOut.comparison.area = 0.26;
    runOut.comparison.areaByChance = 0.03;
    blind.quantities = {runOut};
    blind.figures = {{"run_out_m[Plate].error", "m", {-0.25, -0.375, -0.125}}, {"right_face_share", "", {0.5, unknown, unknown}}};
    blind.verdicts = {{"right_face_share", 0.5, "at least 0.8", false}};
    VariantRecord fitted = blind;
    fitted.name = "fitted";
    fitted.fitted = true;
    fitted.verdicts = {{"run_out_m[Plate].error", -0.25, "at least -0.5", true}};
    return {"tosses", "Tosses of a cube", "ContactNets (2020)", "BSD-3", "", 16, {blind, fitted}};
}

}  // namespace rubble::scenes
