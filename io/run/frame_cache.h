#pragma once

#include <list>
#include <map>
#include <memory>

#include "core/trajectory/trajectory.h"

namespace rubble::io {

/// Keeps the frames that were used last, up to a number of bytes; always at least the newest two, so that interpolation between
/// neighbours never reads one twice.
class FrameCache {
public:
    explicit FrameCache(std::size_t byteLimit) : m_byteLimit(byteLimit) {}

    /// The frame, or null if it is not here.
    std::shared_ptr<const TrajectoryFrame> find(std::size_t index);
    void add(std::size_t index, std::shared_ptr<const TrajectoryFrame> frame);
    std::size_t bytes() const { return m_bytes; }

private:
    struct Entry {
        std::size_t index;
        std::shared_ptr<const TrajectoryFrame> frame;
    };

    std::size_t m_byteLimit;
    std::size_t m_bytes = 0;
    std::list<Entry> m_entries;  ///< used last first
    std::map<std::size_t, std::list<Entry>::iterator> m_places;
};

}  // namespace rubble::io
