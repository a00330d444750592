#pragma once

#include <QImage>
#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/session/worker.h"
#include "core/evidence/cautions.h"
#include "core/evidence/photographs/photo_comparison.h"
#include "core/pipeline/pipeline.h"

namespace rubble {

struct RunRecord;

/// m, farther than this live structure has fallen.
inline constexpr double fallenFrom = 1.0;

/// The file of a photograph as the window shows it.
struct LoadedPhoto {
    QString path;
    QImage picture;      ///< made smaller; null: it cannot be shown
    std::string sha256;  ///< empty: it cannot be read
    Findings findings;
    std::optional<Failure> failure;
};

/// Photographs that were looked at to be added.
struct FoundPhotos {
    struct Photo {
        QString path;
        PhotoFacts facts;
        std::string sha256;
    };
    std::vector<Photo> photos;
    std::vector<Failure> failures;  ///< of those that cannot be
};

/// A run to compare with, kept alive while that takes.
struct EvidenceRun {
    std::shared_ptr<const FeResult> fe;
    std::shared_ptr<const TrajectoryReader> trajectory;
    std::shared_ptr<const FragmentSet> fragments;
    std::shared_ptr<const SimulationResult> result;
    std::shared_ptr<const TerrainGrid> terrain;
    Scenario scenario;

    /// Nothing to compare with: its trajectory is null.
    EvidenceRun() = default;
    EvidenceRun(const Inputs& inputs, const RunRecord* record);
    MappedRun mapped() const { return {fe.get(), trajectory.get(), fragments, result, terrain, scenario}; }
};

/// Reads photographs and holds the debris against them, in the background.
class EvidenceWork : public QObject {
    Q_OBJECT

public:
    explicit EvidenceWork(QObject* parent = nullptr);

    /// Why a run has no debris that evidence can be held against; empty: it has. @param record  null: there is no run
    static QString whyNoDebris(const RunRecord* record);
    /// What must be known where a photograph is held against a run. @param record  null: there is no run
    static std::vector<Caution> cautionsOf(const Photograph& photograph, const std::optional<CameraMatch>& match,
                                           const RunRecord* record);

    /// Looks at files that are to be added; answers with found().
    void find(const QStringList& paths);
    /// Reads a photograph for the screen; answers with loaded(). The latest wins.
    void load(const QString& path);
    /// Outlines of the simulated debris at a time; answers with outlined(). The latest wins.
    void outline(const EvidenceRun& run, const CameraModel& camera, QSize photograph, double time, bool withFallen);
    /// Compares; answers with compared().
    void compare(const EvidenceRun& run, const Photograph& photograph, const CameraMatch& match,
                 const ComparisonSettings& settings);
    void cancelComparison();
    void cancel();
    bool comparing() const { return m_comparing; }
    bool busy() const { return m_comparing || m_files.busy() || m_study.busy(); }

signals:
    void found(const rubble::FoundPhotos& photos);
    void loaded(const rubble::LoadedPhoto& photo);
    void outlined(const std::vector<std::vector<Eigen::Vector2d>>& outlines);
    /// @param made  null: cancelled, or `failure` says why
    void compared(const std::shared_ptr<const rubble::PhotoComparison>& made, const rubble::Failure* failure);

private:
    bool m_comparing = false;
    // Last, so that they have ended before anything they use goes.
    Worker m_files;
    Worker m_study;
};

}  // namespace rubble
