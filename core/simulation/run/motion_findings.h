#pragma once

#include <cstdint>

#include "core/base/finding.h"

namespace rubble {

/// How bodies of a run moved otherwise than the collapse alone would have moved them.
struct MotionAccount {
    std::int64_t heldTogether = 0;  ///< clusters that should have broken up and were left whole
    std::int64_t heldBack = 0;      ///< times that a body was slowed to what anything it touched could have given it
    std::int64_t steps = 0;
    std::int64_t bodies = 0;  ///< of clusters
    std::int64_t moving = 0;  ///< of these, awake at the end
    bool atRest = true;       ///< the run ended because what fell had come to rest
    double end = 0.0;         ///< s
};

/// A finding, with its remedy, for each of these that is not as it should be.
void addMotionFindings(const MotionAccount& account, Findings& findings);

}  // namespace rubble
