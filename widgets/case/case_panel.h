#pragma once

#include <memory>

#include "core/fe/components.h"
#include "core/fe/fe_result.h"
#include "core/fe/terrain_grid.h"
#include "widgets/basics/panel.h"
#include "widgets/case/regroup_form.h"
#include "widgets/case/scenario_list.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace rubble::widgets {

/// What was computed, and of what the structure is made: the file, how it is read, the components and their regrouping.
class CasePanel : public Panel {
    Q_OBJECT

public:
    explicit CasePanel(QWidget* parent = nullptr);

    /// @param fe, components  null while there are none
    void setContent(const std::shared_ptr<const FeResult>& fe, const std::shared_ptr<const Components>& components);
    /// The terrain and what was found when it was read, shown with the next content. @param terrain  null: there is none,
    /// or it could not be read where `path` names one
    void setTerrain(const std::shared_ptr<const TerrainGrid>& terrain, const QString& path, const Findings& findings);
    /// What is drawn around the structure. @param collided  debris falls on the meshes
    void setSurroundings(bool orthophoto, std::size_t meshes, bool collided);
    void setScenario(const Scenario& scenario) override;
    void setEditable(bool editable) override;
    QStringList selectedComponents() const;
    ScenarioList& scenarios() { return *m_scenarios; }

signals:
    void regroupRequested(const rubble::RegroupStep& step);
    /// Back to the parts of the file.
    void regroupingCleared();
    /// Where the model stands, or what debris falls on, is to be said: the remedy of a finding.
    void siteRequested();
    void terrainRequested();

private:
    void buildFile();
    void buildTable();
    void showCells(const TerrainGrid* terrain);
    void showFile(const FeResult* fe);
    void showUnits(const FeResult::Contents& contents);
    void showComponents(const FeResult* fe, const Components* components);
    void densityTyped(int row, int column);

    ScenarioList* m_scenarios;
    PanelGroup* m_scenarioGroup;
    QLabel* m_name;
    QLabel* m_format;
    QLabel* m_elements;
    QLabel* m_nodes;
    QLabel* m_states;
    QLabel* m_span;
    QLabel* m_units;
    QLabel* m_flag;
    QLabel* m_velocity;
    QLabel* m_dead;
    QLabel* m_terrain;
    QLabel* m_cells;
    QLabel* m_surroundings;
    QLabel* m_note;
    QTableWidget* m_table;
    RegroupForm* m_regroup;
    QLabel* m_steps;
    QPushButton* m_clear;
    FindingList* m_findings;
    Findings m_terrainFindings;
    std::shared_ptr<const Components> m_components;
    bool m_filling = false;
};

/// A regrouping step in words: "deck 1, deck 2 joined into deck".
QString regroupText(const RegroupStep& step);
/// Says in `steps` what was regrouped, a line a step; neither is shown where nothing was. @param clear  drops all of it
void showRegrouping(QLabel& steps, QWidget& clear, const std::vector<RegroupStep>& regrouping);

}  // namespace rubble::widgets
