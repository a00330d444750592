#include "widgets/evidence/validation_view.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QTextDocumentFragment>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/basics/panel.h"
#include "widgets/basics/study_start.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/report/validation_rows.h"

namespace rubble::widgets {

namespace {

QTableWidget* validationTableOf(const QStringList& heads, const QString& name) {
    auto* table = new QTableWidget(0, static_cast<int>(heads.size()));
    table->setHorizontalHeaderLabels(heads);
    table->setAccessibleName(name);
    table->verticalHeader()->hide();
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setTabKeyNavigation(false);
    table->setFont(headingFont());
    table->horizontalHeader()->setFont(headingFont());
    table->setShowGrid(false);
    return table;
}

/// Cells hold plain text; what is emphasised in print is emphasised as a whole.
void addValidationRow(QTableWidget& table, const QStringList& cells) {
    const int row = table.rowCount();
    table.insertRow(row);
    for (int column = 0; column < cells.size(); ++column) {
        const QString html = cells[column];
        auto* item = new QTableWidgetItem(QTextDocumentFragment::fromHtml(html).toPlainText());
        item->setToolTip(item->text());
        if (html.contains(QLatin1String("<b>"))) {
            QFont font = table.font();
            font.setBold(true);
            item->setFont(font);
        }
        table.setItem(row, column, item);
    }
}

}  // namespace

ValidationView::ValidationView(QWidget* parent)
    : QWidget(parent),
      m_notice(new Notice),
      m_findings(new FindingList),
      m_sets(new QLabel),
      m_figures(validationTableOf({tr("set, variant"), tr("figure"), tr("measured D"), tr("simulated S"), tr("E = S − D (95 %)"),
                                   tr("area (by chance)"), tr("not known"), tr("asked")},
                                  tr("Measured and simulated falls"))),
      m_parameters(
          validationTableOf({tr("set, variant"), tr("setting"), tr("source")}, tr("What was simulated with, and its source"))),
      m_validate(new QPushButton(tr("Hold against measured falls"))),
      m_cancel(new QPushButton(tr("Cancel"))),
      m_bar(new QProgressBar),
      m_progress(new ProgressLabel) {
    setObjectName(QStringLiteral("panelBody"));
    setAttribute(Qt::WA_StyledBackground);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 12, 16, 12);
    column->setSpacing(8);
    auto* title = new QLabel(tr("Validation: this program held against what really fell"));
    title->setFont(titleFont());
    column->addWidget(title);
    auto* terms = new QLabel(
        tr("Agreement with the reference, in the panel Accuracy, is a verification and says nothing of the world; the self-test "
           "is one too.") +
        u' ' + figures::validationTerms());
    terms->setObjectName(QStringLiteral("muted"));
    terms->setTextFormat(Qt::RichText);
    terms->setWordWrap(true);
    column->addWidget(terms);
    column->addWidget(m_notice);
    column->addWidget(m_findings);
    m_sets->setWordWrap(true);
    m_sets->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_sets);
    auto* tabs = new QTabWidget;
    tabs->addTab(m_figures, tr("Figures"));
    tabs->addTab(m_parameters, tr("Settings and sources"));
    column->addWidget(tabs, 1);
    m_bar->setTextVisible(false);
    m_bar->setRange(0, 1000);
    m_bar->setAccessibleName(tr("Progress of the validation"));
    column->addWidget(m_bar);
    m_progress->setObjectName(QStringLiteral("muted"));
    column->addWidget(m_progress);
    auto* row = new QHBoxLayout;
    m_validate->setObjectName(QStringLiteral("primary"));
    m_validate->setToolTip(tr("Simulates all sets that come with the program, as rubble-cli validate does; takes some minutes"));
    m_cancel->setObjectName(QStringLiteral("cancelValidation"));
    m_cancel->setToolTip(tr("Stop; sets that are done are kept"));
    row->addWidget(m_validate);
    row->addWidget(m_cancel);
    row->addStretch();
    column->addLayout(row);
    connect(m_validate, &QPushButton::clicked, this, &ValidationView::validateRequested);
    connect(m_cancel, &QPushButton::clicked, this, &ValidationView::cancelRequested);
    setContent({});
}

void ValidationView::fillTables(const std::vector<ValidationRecord>& records) {
    m_figures->setRowCount(0);
    m_parameters->setRowCount(0);
    QStringList sets;
    for (const ValidationRecord& record : records) {
        sets << figures::validationSummary(record);
        for (const figures::ValidationRow& row : figures::validationRows(record)) {
            addValidationRow(*m_figures,
                             {row.set, row.figure, row.measured, row.simulated, row.error, row.area, row.lost, row.asked});
        }
        for (const figures::ValidationParameterRow& row : figures::validationParameters(record)) {
            addValidationRow(*m_parameters, {row.set, row.setting, row.source});
        }
    }
    m_figures->resizeColumnsToContents();
    m_parameters->resizeColumnsToContents();
    m_sets->setText(sets.join(QStringLiteral("<br/>")));
    m_sets->setVisible(!sets.isEmpty());
}

void ValidationView::setContent(const Content& content) {
    fillTables(content.records);
    m_findings->set(content.findings);
    if (!m_failed) {
        m_notice->set(Notice::Kind::Note,
                      content.records.empty() && !content.running
                          ? tr("This program was not held against measured falls on this machine yet.")
                          : QString(),
                      tr("Until then its rate of error is not in reports."));
    }
    m_validate->setVisible(!content.running);
    m_cancel->setVisible(content.running);
    m_bar->setVisible(content.running);
    m_progress->setVisible(content.running);
}

void ValidationView::setProgress(const QString& what, double fraction, double secondsLeft) {
    m_bar->setValue(static_cast<int>(std::lround(1000.0 * fraction)));
    m_progress->setProgress(what, secondsLeft);
}

void ValidationView::setError(const QString& what, const QString& remedy) {
    m_failed = !what.isEmpty();
    m_notice->set(Notice::Kind::Error, what, remedy);
}

}  // namespace rubble::widgets
