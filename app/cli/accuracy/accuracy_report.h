#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/frame/json_output.h"
#include "app/cli/frame/subject.h"
#include "app/cli/frame/text_table.h"
#include "core/analysis/accuracy/accuracy_study.h"
#include "core/analysis/accuracy/prediction.h"

namespace rubble::cli {

/// What was predicted of one setting before it was simulated, by Predicted.
using Predictions = std::array<Prediction, predictedCount>;

/// A sweep as tables and JSON.
struct AccuracyOutput {
    const io::OpenedCase& subject;
    const AccuracyReport& report;
    const AccuracyOptions& options;
    std::vector<Predictions> predictions;  ///< of the points, in their order
    std::optional<std::vector<PredictionCheck>> checks;
    std::size_t knownPoints = 0;  ///< of the scene, that the check rests on
    std::string cacheFolder;

    /// One row for each fragment and setting that is done: its distance from where it lies in the reference.
    TextTable errorTable() const;
    Json json() const;
    void print(std::ostream& out) const;

private:
    TextTable costTable() const;
    TextTable measureTable() const;
    /// Only of settings that were repeated.
    TextTable spreadTable() const;
    TextTable predictionTable() const;
    TextTable checkTable() const;
};

}  // namespace rubble::cli
