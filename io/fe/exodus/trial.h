#pragma once

#include <functional>

namespace rubble::io {

/// Runs work in a child process and waits for it. Libraries can crash on a damaged file (the packaged HDF5, GDAL), and leave
/// objects open where they do not; here neither reaches this process. What the work throws of our errors is thrown here in its
/// place; its other effects stay in the child. If no child can be had, the work is done in this process.
/// @return false if the work crashed, or ran longer than two minutes
/// Call it under a LibraryLock: the child must not inherit a library in the middle of another thread's call.
bool survivesTrial(const std::function<void()>& work);

}  // namespace rubble::io
