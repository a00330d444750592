#pragma once

#include <cstddef>
#include <functional>

#include "core/base/execution.h"

namespace rubble {

/// Does `count` independent pieces of work, each once, on threads of its own: whole worlds, which know nothing of each other, so
/// that no result depends on the number of threads. Pieces begin in order. Returns when all threads have ended.
/// @param threads    in all; 0: as many as the execution grants. Where there are more threads than pieces, a piece may use several
/// @param stage      what is being done, for progress; progress is the mean over all pieces and is reported from the calling thread
/// @param work       called with the number of the piece, from several threads, with an execution of its own
/// Throws Cancelled when the execution was cancelled; the error of the first piece in order that failed, after the rest was
/// stopped. Pieces that were done by then stay done.
void runInParallel(std::size_t count, int threads, const Message& stage, const Execution& execution,
                   const std::function<void(std::size_t, const Execution&)>& work);

}  // namespace rubble
