#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "io/base/file_stamp.h"

namespace rubble::io {

/// Runs work in a child process and waits for it. Libraries can crash on a damaged file (the packaged HDF5, GDAL), and leave
/// objects open where they do not; here neither reaches this process. What the work throws of our errors is thrown here in its
/// place; its other effects stay in the child. If no child can be had, the work is done in this process.
/// A child may inherit a lock that another thread of this process held, of the allocator say: one that makes no use
/// of the processor for as long as longestStill is ended and tried again twice; then the work is done in this process.
/// @return false if the work crashed, or took the processor for longer than two minutes
/// Call it under a LibraryLock: the child must not inherit a library in the middle of another thread's call.
bool survivesTrial(const std::function<void()>& work, std::chrono::seconds longestStill = std::chrono::seconds(10));

/// What was learnt of files in trials, for as long as the program runs and they stay as they are. A child costs the parent its
/// pages as well: each is copied when it is written to next. Under a LibraryLock.
template <class Learnt>
class TriedFiles {
public:
    /// @param learn  () what a trial of the file says; what it throws is not kept, nor that there is nothing (Learnt())
    template <class Learn>
    Learnt of(const std::string& path, const Learn& learn) {
        const std::optional<FileStamp> stamp = settledStamp(path);
        if (!stamp) {
            return learn();
        }
        if (const auto found = m_learnt.find(*stamp); found != m_learnt.end()) {
            return found->second;
        }
        Learnt learnt = learn();
        // One that was written to meanwhile is tried again, and so is one of which nothing was learnt: that may pass.
        if (learnt != Learnt() && settledStamp(path) == stamp) {
            m_learnt.emplace(*stamp, learnt);
        }
        return learnt;
    }

private:
    std::map<FileStamp, Learnt> m_learnt;
};

}  // namespace rubble::io
