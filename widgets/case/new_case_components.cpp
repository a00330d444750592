#include "widgets/case/new_case_components.h"

#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <algorithm>

#include "widgets/case/case_panel.h"

namespace rubble::widgets {

NewCaseComponents::NewCaseComponents(QWidget* parent)
    : Panel(tr("Components"), tr("Of what the structure is made, and into which parts it falls."), parent),
      m_tree(new ComponentTree),
      m_form(new RegroupForm),
      m_steps(new QLabel),
      m_clear(new QPushButton(tr("Back to the parts of the file"))),
      m_findings(new FindingList) {
    PanelGroup* parts = addGroup(tr("Parts of the structure"));
    parts->addNote(tr("Choose one to set its material; choose several to join them. The preview marks what is chosen."));
    m_tree->setMinimumHeight(280);
    parts->addWide(m_tree);
    parts->addWide(m_form);
    m_steps->setObjectName(QStringLiteral("muted"));
    m_steps->setWordWrap(true);
    parts->addWide(m_steps);
    m_clear->setToolTip(tr("Drop all regrouping"));
    parts->addWide(m_clear);
    addRemaining(Stage::Components, tr("Assumed where nothing is known"));
    addWide(m_findings);
    connect(m_form, &RegroupForm::regroupRequested, this, &NewCaseComponents::regroupRequested);
    connect(m_clear, &QPushButton::clicked, this, &NewCaseComponents::regroupingCleared);
    connect(&m_tree->tree(), &QTreeWidget::itemSelectionChanged, this, &NewCaseComponents::showChosen);
    setContent(nullptr);
}

void NewCaseComponents::setContent(const Components* components) {
    m_names.clear();
    m_bounds.clear();
    if (components != nullptr) {
        for (const Component& component : components->list) {
            m_names.push_back(component.name);
            m_bounds.push_back(component.bounds);
        }
    }
    m_findings->set(components != nullptr ? components->findings : Findings());
    showChosen();
}

void NewCaseComponents::showChosen() {
    const std::vector<std::string> names = m_tree->chosen();
    QStringList all;
    QStringList those;
    for (const std::string& name : m_names) {
        all << QString::fromStdString(name);
    }
    for (const std::string& name : names) {
        those << QString::fromStdString(name);
    }
    m_form->setSelection(those, all);
    const auto place = names.size() == 1 ? std::find(m_names.begin(), m_names.end(), names.front()) : m_names.end();
    if (place != m_names.end()) {
        m_form->setBounds(m_bounds[static_cast<std::size_t>(place - m_names.begin())]);
    }
    emit chosen(names);
}

void NewCaseComponents::setScenario(const Scenario& scenario) {
    Panel::setScenario(scenario);
    showRegrouping(*m_steps, *m_clear, scenario.regrouping);
}

}  // namespace rubble::widgets
