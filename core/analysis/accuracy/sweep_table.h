#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/accuracy/accuracy_study.h"

namespace rubble {

/// One row of a sweep as its columns need it.
struct SweepRow {
    std::string setting;
    std::array<double, 3> multiple{};  ///< x, y, z; NaN with a body per fragment
    std::array<double, 3> grid{};      ///< m; likewise
    std::int64_t fragments = 0;
    std::int64_t bodies = 0;
    const DebrisDifference* difference = nullptr;  ///< of the report, which outlives the row
    SettingCost cost;
};

/// The reference, the floor, and what is done of the settings, in this order.
std::vector<SweepRow> sweepRows(const AccuracyReport& report);

/// One column: its key, unit included, and its value of a row; NaN where there is none.
struct SweepColumn {
    std::string_view key;
    double (*value)(const SweepRow& row);
    bool whole = false;  ///< a count
};

/// All columns but the first, "setting".
const std::vector<SweepColumn>& sweepColumns();

/// The table of a sweep: RFC 4180, one heading row of keys, numbers to the last bit, an empty field where there is none.
void writeSweepCsv(const AccuracyReport& report, std::ostream& out);

inline constexpr std::array<double, 3> publishedTolerances{0.1, 0.2, 0.3};  ///< m
/// The share of fragments within one of the three distances of the published table, by number; NaN if it was not among the
/// tolerances.
double publishedRate(const DebrisDifference& difference, std::size_t number);

}  // namespace rubble
