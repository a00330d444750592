#pragma once

#include "widgets/basics/panel.h"
#include "widgets/case/component_tree.h"
#include "widgets/case/regroup_form.h"

class QPushButton;

namespace rubble::widgets {

/// Third step of a new case: of what the structure is made, and into which components it falls. Whoever shows it fills the tree.
class NewCaseComponents : public Panel {
    Q_OBJECT

public:
    explicit NewCaseComponents(QWidget* parent = nullptr);

    ComponentTree& tree() { return *m_tree; }
    RegroupForm& form() { return *m_form; }
    void setContent(const Components* components);
    void setScenario(const Scenario& scenario) override;

signals:
    void regroupRequested(const rubble::RegroupStep& step);
    void regroupingCleared();
    /// Other rows are chosen: these components.
    void chosen(const std::vector<std::string>& names);

private:
    void showChosen();

    ComponentTree* m_tree;
    RegroupForm* m_form;
    QLabel* m_steps;
    QPushButton* m_clear;
    FindingList* m_findings;
    std::vector<std::string> m_names;  ///< of all components
    std::vector<Aabb> m_bounds;        ///< by component, m
};

}  // namespace rubble::widgets
