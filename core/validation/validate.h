#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/validation/comparison.h"
#include "core/validation/validation_set.h"

namespace rubble {

/// A quantity that was measured and simulated, of all bodies or of one group.
struct QuantityComparison {
    std::string key;    ///< "run_out_m", of a group "run_out_m[Plate]"
    std::string title;  ///< "run-out", of a group "run-out, Plate"
    std::string unit;
    PairedValues values;
    SampleComparison comparison;
};

/// A figure of a variant, with its interval where one is known.
struct SetFigure {
    std::string key;  ///< "position_error_m.median"
    std::string unit;
    ConfidenceInterval value;
};

/// A criterion as it came out.
struct SetVerdict {
    SetCriterion criterion;
    double value = 0.0;
    double limit = 0.0;  ///< of `below`, the other figure
    bool within = false;
};

/// Where a body came to lie, m in the axes of its table.
struct Deposit {
    Vec3 measured = Vec3::Zero();
    std::vector<Vec3> simulated;  ///< in the repeats of which the end is known
};

/// What became of one variant of a set.
struct VariantResult {
    SetVariant variant;
    std::vector<SetParameter> used;  ///< what was set, fitted values among it
    std::int64_t bodies = 0;         ///< that are judged
    std::int64_t simulated = 0;      ///< bodies and repeats
    std::int64_t moving = 0;         ///< of these, still on their way at the end
    std::int64_t left = 0;           ///< that left the terrain
    std::int64_t lost = 0;           ///< that were lost or refused
    std::vector<QuantityComparison> quantities;
    std::vector<Deposit> deposits;   ///< [bodies] that are judged
    std::vector<SetFigure> figures;  ///< all, those of the quantities among them
    std::vector<SetVerdict> verdicts;
    double stepRate = 0.0;   ///< 1/s, at least; 0: a scene of its own
    Message stepRateReason;  ///< why so many
    double seconds = 0.0;    ///< wall time of its simulations, added up: several may run at once

    /// Its value; not a number if there is no such figure.
    double figure(const std::string& key) const;
};

/// A set held against its measurements.
struct SetResult {
    const ValidationSet* set = nullptr;
    std::vector<VariantResult> variants;
    Findings findings;
};

/// Holds the figures of a variant against what is asked of them.
void judge(VariantResult& result, const ValidationSet& set);

/// What a set is simulated and compared with.
struct ValidationOptions {
    std::optional<std::int64_t> repeats;  ///< in place of those of the set
    std::int64_t seed = 1;
    int resamplings = 2000;
};

/// Simulates every variant of a set and compares it with what was measured. Bodies never meet: each was let go alone. Values of
/// bodies that were measured after a time are taken at that time, of the others once they rest; what moves on, leaves the terrain
/// or is lost counts as lost and in no mean. The same set and options give the same numbers. Throws UsageError for settings that
/// there are not, what the pipeline throws, and Cancelled.
SetResult validate(const ValidationSet& set, const ValidationOptions& options, const Execution& execution);

}  // namespace rubble
