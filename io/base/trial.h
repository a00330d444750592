#pragma once

#include <chrono>
#include <functional>

namespace rubble::io {

/// Runs work in a child process and waits for it. Libraries can crash on a damaged file (the packaged HDF5, GDAL), and leave
/// objects open where they do not; here neither reaches this process. What the work throws of our errors is thrown here in its
/// place; its other effects stay in the child. If no child can be had, the work is done in this process.
/// A child may inherit a lock that another thread of this process held, of the allocator say: one that makes no use
/// of the processor for as long as longestStill is ended and tried again twice; then the work is done in this process.
/// @return false if the work crashed, or took the processor for longer than two minutes
/// Call it under a LibraryLock: the child must not inherit a library in the middle of another thread's call.
bool survivesTrial(const std::function<void()>& work, std::chrono::seconds longestStill = std::chrono::seconds(10));

}  // namespace rubble::io
