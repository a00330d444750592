#pragma once

#include <mutex>
#include <ostream>
#include <string>

#include "core/base/execution.h"
#include "core/pipeline/time_left.h"

namespace rubble::cli {

/// One line on a terminal that is rewritten in place: stage, per cent done, time left. Switched off, it says only that something
/// goes on from a checkpoint, which is a line of its own.
class ProgressLine {
public:
    ProgressLine(std::ostream& stream, bool on) : m_stream(stream), m_on(on) {}
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(const Progress& progress);
    /// Wipes the line, so that other text can follow.
    void clear();

private:
    void say(const Message& stage);

    std::ostream& m_stream;
    const bool m_on;
    std::mutex m_mutex;
    bool m_shown = false;
    std::string m_said;
    TimeLeft m_left;
};

}  // namespace rubble::cli
