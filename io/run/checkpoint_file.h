#pragma once

#include <string>

#include "core/simulation/run/checkpoint.h"

namespace rubble::io {

/// Keeps the checkpoints of a run in one file, written atomically. Processes that simulate the same run may share it: what one of
/// them wrote is right for all.
class CheckpointFile : public CheckpointStore {
public:
    /// Makes the folder when something is kept. Throws what checkpointSeconds() throws.
    explicit CheckpointFile(std::string path);

    std::optional<std::string> latest() override;
    void keep(std::string_view checkpoint) override;
    double interval() const override { return m_interval; }
    /// The run is done: takes the file away, and what processes that were killed while writing it left beside it.
    void remove();

private:
    std::string m_path;
    double m_interval;
};

}  // namespace rubble::io
