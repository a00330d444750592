#pragma once

#include <memory>

#include "core/clusters/clustering.h"
#include "core/clusters/sizing.h"
#include "core/fe/components.h"
#include "core/fe/mesh.h"
#include "widgets/panel.h"

class QLabel;
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
    };

    explicit GridPanel(QWidget* parent = nullptr);
    void setContent(const Content& content);
    void setScenario(const Scenario& scenario) override;

    /// The slider's scale: logarithmic from 0.5 to 50 times the mean distance.
    static double multipleAt(int position);
    static int positionOf(double multiple);

signals:
    /// The slider is being dragged; edits between this and draggingEnded() are one step of undo.
    void draggingStarted();
    void draggingEnded();

private:
    void buildTable(PanelGroup* group);
    void showAxis(int row, const AxisSizing& axis, const Content& content);
    QString clampSentence(char name, const AxisSizing& axis, const Content& content) const;
    void showResult(const Content& content);

    QSlider* m_slider;
    QTableWidget* m_table;
    Notice* m_clamps;
    QLabel* m_fragments;
    QLabel* m_clusters;
    QLabel* m_perCluster;
    QLabel* m_splits;
    QLabel* m_stopped;
    FindingList* m_findings;
};

}  // namespace rubble::widgets
