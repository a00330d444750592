#pragma once

#include <string>
#include <vector>

#include "core/validation/validate.h"

namespace rubble {

/// A quantity of a set of measured falls, as it was measured and simulated.
struct QuantityRecord {
    std::string key;    ///< as in QuantityComparison
    std::string title;  ///< the same
    std::string unit;
    SampleComparison comparison;
};

/// A figure held against what is asked of it.
struct VerdictRecord {
    std::string figure;
    double value = 0.0;
    std::string asked;  ///< "at least 0.54, at most 0.67"
    bool within = false;
};

/// What became of one variant of a set.
struct VariantRecord {
    std::string name;
    std::string words;
    std::vector<SetParameter> parameters;
    bool fitted = false;  ///< some of them on one half, judged on the other
    std::int64_t bodies = 0;
    std::int64_t falls = 0;
    std::int64_t moving = 0;
    std::int64_t left = 0;
    std::int64_t lost = 0;
    double stepRate = 0.0;
    std::string stepRateReason;
    std::vector<QuantityRecord> quantities;
    std::vector<SetFigure> figures;  ///< all, those of the quantities among them
    std::vector<VerdictRecord> verdicts;
    double seconds = 0.0;

    /// Those that belong to no quantity.
    std::vector<SetFigure> otherFigures() const;
};

/// What came of holding the simulation against one set, without its falls: command line, report and window show it.
struct ValidationRecord {
    std::string id;
    std::string title;
    std::string source;
    std::string licence;
    std::string folder;  ///< empty: a scene of the program's own
    std::size_t bodies = 0;
    std::vector<VariantRecord> variants;
};

ValidationRecord recordOf(const SetResult& result);

}  // namespace rubble
