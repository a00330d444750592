#include "widgets/new_case_summary.h"

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
    m_settled = addGroup(tr("Settled"));
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

void NewCaseSummary::setRows(const std::vector<std::pair<QString, QString>>& rows) {
    // Rows are few and always the same ones: only their values change.
    for (std::size_t i = m_values.size(); i < rows.size(); ++i) {
        m_values.push_back(m_settled->addValue(rows[i].first));
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        m_values[i]->setText(rows[i].second);
    }
}

}  // namespace rubble::widgets
