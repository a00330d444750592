#pragma once

#include <functional>

#include "core/base/finding.h"
#include "core/pipeline/pipeline.h"

namespace rubble {

/// What watches a run of the pipeline; on the thread that runs it. Unset functions are not called.
struct StageObserver {
    std::function<void(Stage)> begins;
    /// The part of a stage is there, made or reused. Results hold the parts and keys up to it.
    std::function<void(Stage, const Results&)> made;
};

/// As run() without an observer; that one is told of each stage from the components on.
Results run(const Inputs& inputs, const Scenario& scenario, Stage last, const Results& previous, TrajectorySink* sink,
            const Execution& execution, CheckpointStore* checkpoints, const StageObserver& observer);

/// Of all parts that are there, in the order data flows; one row for each kind.
Findings stageFindings(const Results& results);

}  // namespace rubble
