#pragma once

#include <string>

#include "core/analysis/accuracy/settled_world.h"
#include "io/run/study_files.h"

namespace rubble::io {

/// Keeps settled worlds in a folder: the world as StudyFiles does, so that other studies find it, and beside it islands/KEY.json
/// with the islands that were released and the arrivals of debris. Written atomically, the world last: what is there is whole.
class SettledFiles : public SettledStore {
public:
    /// Makes the folder when something is kept.
    explicit SettledFiles(std::string folder) : m_worlds(std::move(folder)) {}

    std::optional<SettledWorld> settled(const WorldOrigin& origin, Findings& findings) override;
    void keep(const WorldOrigin& origin, const SettledWorld& settled) override;
    std::unique_ptr<CheckpointStore> checkpoints(const WorldOrigin& origin) override { return m_worlds.checkpoints(origin); }
    /// Whether a whole world with its islands is kept.
    bool keeps(const WorldOrigin& origin);

    /// Where the islands of a world are kept.
    std::string islandsPath(const WorldOrigin& origin) const;
    const StudyFiles& worlds() const { return m_worlds; }

private:
    StudyFiles m_worlds;
};

}  // namespace rubble::io
