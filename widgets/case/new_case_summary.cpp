#include "widgets/case/new_case_summary.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>

namespace rubble::widgets {

NewCaseSummary::NewCaseSummary(QWidget* parent)
    : Panel(tr("Case"), tr("What the case is called, and what was settled."), parent),
      m_title(new QLineEdit),
      m_scenario(new QLineEdit),
      m_note(new QPlainTextEdit) {
    PanelGroup* names = addGroup(tr("Names"));
    m_title->setObjectName(QStringLiteral("caseTitle"));
    m_title->setAccessibleName(tr("Name of the case"));
    names->addField(tr("Name of the case"), m_title, {}, tr("As it stands in the title of the window and in reports"));
    m_scenario->setObjectName(QStringLiteral("scenarioName"));
    m_scenario->setAccessibleName(tr("First scenario"));
    names->addField(tr("First scenario"), m_scenario, {}, tr("What these settings are called among others of the case"));
    m_note->setObjectName(QStringLiteral("caseNote"));
    m_note->setAccessibleName(tr("Note"));
    m_note->setTabChangesFocus(true);
    m_note->setFixedHeight(4 * m_note->fontMetrics().lineSpacing() + 12);
    m_note->setPlaceholderText(tr("What is known of this analysis, and by whom it was made"));
    names->addField(tr("Note"), m_note, {}, tr("Kept with the scenario"));
    PanelGroup* settled = addGroup(tr("Settled"));
    m_feResult = settled->addValue(tr("FE result"));
    m_units = settled->addValue(tr("Units"));
    m_upAxis = settled->addValue(tr("Up"));
    m_ground = settled->addValue(tr("Ground"));
    m_components = settled->addValue(tr("Components"));
    m_regrouping = settled->addValue(tr("Steps of regrouping"));
    m_fragments = settled->addValue(tr("Fragments"));
    connect(m_title, &QLineEdit::textChanged, this, &NewCaseSummary::namedChanged);
    connect(m_scenario, &QLineEdit::textChanged, this, &NewCaseSummary::namedChanged);
}

void NewCaseSummary::propose(const QString& title, const QString& scenario) {
    if (!m_title->isModified()) {
        m_title->setText(title);
    }
    if (!m_scenario->isModified()) {
        m_scenario->setText(scenario);
    }
}

QString NewCaseSummary::title() const {
    return m_title->text().trimmed();
}

QString NewCaseSummary::scenarioName() const {
    return m_scenario->text().trimmed();
}

QString NewCaseSummary::note() const {
    return m_note->toPlainText().trimmed();
}

void NewCaseSummary::setSettled(const Settled& settled) {
    m_feResult->setText(settled.feResult);
    m_units->setText(settled.units);
    m_upAxis->setText(settled.upAxis);
    m_ground->setText(settled.ground);
    m_components->setText(settled.components);
    m_regrouping->setText(settled.regrouping);
    m_fragments->setText(settled.fragments);
}

}  // namespace rubble::widgets
