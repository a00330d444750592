#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/analysis/accuracy/calibration.h"
#include "core/analysis/accuracy/prediction.h"
#include "core/analysis/accuracy/study_store.h"

namespace rubble::io {

/// Keeps studies in a folder: worlds/KEY.world (binary, with a checksum at its end), checkpoints/KEY.checkpoint while a world is
/// simulated, costs/, points/ and calibration/ as JSON.
/// Every file is written atomically and names what it was made from; what does not fit, is damaged or of a newer version is left
/// alone and made again.
class StudyFiles : public StudyStore {
public:
    /// Makes the folder when something is kept.
    explicit StudyFiles(std::string folder) : m_folder(std::move(folder)) {}

    std::optional<SimulatedWorld> world(const WorldOrigin& origin, Findings& findings) override;
    /// Removes the checkpoint of the world.
    void keep(const WorldOrigin& origin, const SimulatedWorld& world) override;
    std::unique_ptr<CheckpointStore> checkpoints(const WorldOrigin& origin) override;
    /// Whether a whole world is kept.
    bool keeps(const WorldOrigin& origin);
    std::optional<SettingCost> cost(const WorldOrigin& origin, int threads) override;
    void keep(const WorldOrigin& origin, const SettingCost& cost) override;

    /// Earlier points of a scene, by name of file: of all machines. Files that cannot be read are passed over, counted.
    std::vector<KnownPoint> points(const Digest& scene, Findings& findings) const;
    /// A point with the same scene, machine, parameters and bodies takes the place of what was kept; a figure that is not known
    /// now stays as it was.
    void keep(const KnownPoint& point);

    /// The calibration of a machine; unset if there is none or its file is damaged, which is a finding.
    std::optional<Calibration> calibration(const std::string& machine, Findings& findings) const;
    /// Throws WorldError.
    void keep(const Calibration& calibration);
    std::string calibrationPath(const std::string& machine) const;

    const std::string& folder() const { return m_folder; }
    /// Where a world is kept.
    std::string worldPath(const WorldOrigin& origin) const;
    std::string checkpointPath(const WorldOrigin& origin) const;

private:
    std::string costPath(const WorldOrigin& origin, int threads) const;
    std::string pointPath(const KnownPoint& point) const;

    std::string m_folder;
};

/// Keeps what was measured for later predictions; a folder without room is a finding of the report.
void keepPoints(StudyFiles& files, AccuracyReport& report);

}  // namespace rubble::io
