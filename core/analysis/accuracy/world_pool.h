#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/base/execution.h"

namespace rubble {

/// How pieces of work share the machine.
struct PoolShare {
    int threads = 0;                   ///< in all; 0: as many as the execution grants
    int atOnce = 0;                    ///< pieces at a time at most; 0: one for each thread
    std::vector<double> weights = {};  ///< how much work each piece is, for progress; empty: all alike
};

/// Does `count` independent pieces of work, each once, on threads of its own: whole worlds, which know nothing of each other, so
/// that no result depends on the number of threads. Pieces begin in order. Returns when all threads have ended.
/// @param share      where there are more threads than pieces at a time, a piece may use several
/// @param stage      what is being done, for progress; progress is the weighted mean of how far all pieces have been
/// simulated (simulatingStage) and is reported from the calling thread
/// @param work       called with the number of the piece, from several threads, with an execution of its own
/// Throws Cancelled when the execution was cancelled; the error of the first piece in order that failed, after the rest was
/// stopped. Pieces that were done by then stay done.
void runInParallel(std::size_t count, const PoolShare& share, const Message& stage, const Execution& execution,
                   const std::function<void(std::size_t, const Execution&)>& work);

}  // namespace rubble
