#pragma once

#include <optional>

#include "widgets/basics/panel.h"

class QPushButton;

namespace rubble::widgets {

/// Second step of a new case: on what the debris falls.
class NewCaseGround : public Panel {
    Q_OBJECT

public:
    explicit NewCaseGround(QWidget* parent = nullptr);

    /// @param structure  box of the structure at rest, m; empty until a file is read
    void setStructure(const Aabb& structure);
    /// @param path       of the raster of heights, empty without terrain
    /// @param clearance  m, of the node of the structure nearest to it, negative below it; unset: not known
    void setTerrain(const QString& path, const std::optional<double>& clearance, const Findings& findings);
    void setScenario(const Scenario& scenario) override;

signals:
    void terrainRequested();
    void terrainDropped();

private:
    void showGap();

    QLabel* m_lowest;
    Notice* m_gap;
    Notice* m_terrainGap;
    QPushButton* m_toLowest;
    QLabel* m_terrain;
    QPushButton* m_drop;
    FindingList* m_findings;
    Aabb m_structure;
    double m_height = 0.0;
    bool m_hasTerrain = false;
    std::optional<double> m_clearance;
};

}  // namespace rubble::widgets
