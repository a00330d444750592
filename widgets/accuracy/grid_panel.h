#pragma once

#include <array>
#include <memory>
#include <optional>

#include "core/analysis/accuracy/calibration.h"
#include "core/clusters/clustering.h"
#include "core/clusters/sizing.h"
#include "core/fe/components.h"
#include "core/fe/mesh.h"
#include "widgets/basics/panel.h"

class QLabel;
class QPushButton;
class QSlider;
class QTableWidget;

namespace rubble::widgets {

/// Which fragments move together, and what that costs: target, size by axis with its bounds, and the clusters that come of it.
class GridPanel : public Panel {
    Q_OBJECT

public:
    /// What the panel shows of the results; parts may be missing.
    struct Content {
        std::shared_ptr<const Sizing> sizing;
        std::shared_ptr<const Clustering> clustering;
        std::shared_ptr<const FragmentSet> fragments;
        std::shared_ptr<const Components> components;
        const Mesh* mesh = nullptr;
        bool counted = false;  ///< counted for the place of the slider; clusters are made when it rests
    };
    /// What the calibration of this machine says of the target.
    struct MachineAdvice {
        bool calibrated = false;
        bool disturbed = false;  ///< other programs worked meanwhile: nothing is offered
        double target = 0.0;     ///< frames per second
        std::optional<Calibration::BodiesMax> typical;
        std::optional<Calibration::BodiesMax> worst;
    };
    /// Clusters at a multiple that the published method names.
    struct PublishedCount {
        double multiple = 0.0;
        std::size_t clusters = 0;
    };

    explicit GridPanel(QWidget* parent = nullptr);
    void setContent(const Content& content);
    void setAdvice(const MachineAdvice& advice);
    /// What moves beside the fragments and is not among the bodies allowed; unset: nothing, or not known yet.
    void setBeside(const std::optional<Finding>& caution);
    /// Empty: being counted.
    void setPublishedCounts(const std::vector<PublishedCount>& counts);
    void setScenario(const Scenario& scenario) override;
    /// The slider is held: what takes long waits until it is let go.
    bool dragging() const;

    /// The slider's scale: logarithmic from 0.5 to 50 times the mean distance.
    static double multipleAt(int position);
    static int positionOf(double multiple);
    /// The multiples of the mean distance that the published method recommends, and the one between.
    static constexpr std::array<double, 3> publishedMultiples{2.0, 2.5, 3.0};

signals:
    /// The slider is being dragged; edits between this and draggingEnded() are one step of undo.
    void draggingStarted();
    void draggingEnded();
    void calibrationRequested();

private:
    void buildTarget();
    void buildSize();
    void buildTable(PanelGroup* group);
    void buildResult();
    void showAxis(int row, const AxisSizing& axis, const Content& content);
    void showReasons(const Content& content);
    void showResult(const Content& content);
    void showAutomatic(const Sizing& sizing);

    QLabel* m_advice;
    FindingList* m_beside;
    QString m_besideWords;
    QPushButton* m_use;
    QSlider* m_slider;
    Notice* m_multipleWhy;
    std::array<Notice*, 3> m_axisWhy{};
    QTableWidget* m_table;
    QLabel* m_unitNote = nullptr;
    QLabel* m_fragments;
    QLabel* m_clusters;
    QLabel* m_awake;
    QLabel* m_perCluster;
    QLabel* m_splits;
    QLabel* m_stopped;
    std::array<QLabel*, publishedMultiples.size()> m_published{};
    QLabel* m_ours;
    FindingList* m_findings;
    GridSettings m_settings;
    std::int64_t m_offered = 0;
};

}  // namespace rubble::widgets
