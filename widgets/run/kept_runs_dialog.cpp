#include "widgets/run/kept_runs_dialog.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMap>
#include <QMessageBox>
#include <QPushButton>
#include <QShortcut>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <numeric>

#include "widgets/basics/form_row.h"
#include "widgets/basics/table_cell.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

enum Column { CaseName, When, ScenarioName, State, Size, ColumnCount };

QString shownSize(qint64 bytes) {
    return QLocale().formattedDataSize(bytes, 2, QLocale::DataSizeIecFormat);
}

QString caseName(const KeptRunLine& line) {
    return line.casePath.isEmpty() ? KeptRunsDialog::tr("not known") : QFileInfo(line.casePath).fileName();
}

qint64 sizeOf(const std::vector<const KeptRunLine*>& lines) {
    return std::accumulate(lines.begin(), lines.end(), qint64{0},
                           [](qint64 sum, const KeptRunLine* line) { return sum + line->bytes; });
}

}  // namespace

KeptRunsDialog::KeptRunsDialog(QWidget* parent)
    : QDialog(parent),
      m_total(new QLabel),
      m_table(new QTableWidget(0, ColumnCount)),
      m_details(new QLabel),
      m_open(new QPushButton(tr("Open"))),
      m_remove(new QPushButton(tr("Remove…"))),
      m_undo(new QPushButton(tr("Undo"))) {
    setObjectName(QStringLiteral("keptRuns"));
    setWindowTitle(tr("Kept runs"));
    setProperty("help", QStringLiteral("Run#Keeping runs"));
    resize(860, 520);
    auto* column = dialogColumn(*this);
    m_total->setObjectName(QStringLiteral("keptTotal"));
    m_total->setWordWrap(true);
    column->addWidget(m_total);
    m_table->setAccessibleName(tr("Kept runs of all cases"));
    m_table->setHorizontalHeaderLabels({tr("Case"), tr("Ended"), tr("Scenario"), tr("State"), tr("Size")});
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(ScenarioName, QHeaderView::Stretch);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setTabKeyNavigation(false);
    column->addWidget(m_table, 1);
    m_details->setObjectName(QStringLiteral("muted"));
    m_details->setWordWrap(true);
    // Room for two lines, so that nothing moves with the selection.
    m_details->setMinimumHeight(2 * m_details->fontMetrics().lineSpacing());
    m_details->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    column->addWidget(m_details);
    buildButtons(*column);
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &KeptRunsDialog::choose);
    connect(m_table, &QTableWidget::itemActivated, this, &KeptRunsDialog::openChosen);
    setUndo(0);
    fill();
}

void KeptRunsDialog::buildButtons(QVBoxLayout& column) {
    auto* row = new QHBoxLayout;
    m_open->setObjectName(QStringLiteral("openRun"));
    m_open->setToolTip(tr("Open the case and show this run in its views (Enter)"));
    m_remove->setObjectName(QStringLiteral("removeRun"));
    m_remove->setToolTip(tr("Remove the files of the selected runs (Delete); asks before"));
    m_undo->setObjectName(QStringLiteral("undoRemove"));
    m_undo->setToolTip(tr("Bring back what was removed since this window opened (Ctrl+Z)"));
    auto* close = new QPushButton(tr("Close"));
    close->setToolTip(tr("Close this window; what was removed is gone then (Esc)"));
    row->addWidget(m_open);
    row->addWidget(m_remove);
    row->addWidget(m_undo);
    row->addStretch();
    row->addWidget(close);
    column.addLayout(row);
    for (QPushButton* button : {m_open, m_remove, m_undo, close}) {
        // Enter in the table opens the run there.
        button->setAutoDefault(false);
    }
    connect(m_open, &QPushButton::clicked, this, &KeptRunsDialog::openChosen);
    connect(m_remove, &QPushButton::clicked, this, &KeptRunsDialog::remove);
    connect(m_undo, &QPushButton::clicked, this, &KeptRunsDialog::undoRequested);
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    connect(new QShortcut(QKeySequence::Delete, this), &QShortcut::activated, m_remove, &QPushButton::click);
    connect(new QShortcut(QKeySequence::Undo, this), &QShortcut::activated, m_undo, &QPushButton::click);
}

void KeptRunsDialog::setContent(std::vector<KeptRunLine> lines, int capGib) {
    if (lines == m_lines && capGib == m_capGib) {
        return;
    }
    m_lines = std::move(lines);
    m_capGib = capGib;
    fill();
}

void KeptRunsDialog::setUndo(int runs) {
    m_undo->setEnabled(runs > 0);
}

void KeptRunsDialog::fill() {
    const int row = std::max(0, m_table->currentRow());
    m_table->setRowCount(0);
    m_table->setRowCount(static_cast<int>(m_lines.size()));
    for (int i = 0; i < m_table->rowCount(); ++i) {
        const KeptRunLine& line = m_lines[static_cast<std::size_t>(i)];
        const QString when = QLocale().toString(line.when.toLocalTime(), QLocale::ShortFormat);
        const QString state = line.shown ? tr("%1 · shown").arg(line.state) : line.state;
        m_table->setItem(i, CaseName, tableCell(caseName(line), true, line.casePath));
        m_table->setItem(i, When, tableCell(when, true, when));
        m_table->setItem(i, ScenarioName, tableCell(line.scenario, true, line.scenario));
        m_table->setItem(i, State, tableCell(state, true, line.path));
        m_table->setItem(i, Size, tableCell(shownSize(line.bytes), false, line.path));
    }
    if (!m_lines.empty()) {
        // Keys that are still held, as that of Undo, are none of the selection's.
        const QModelIndex index = m_table->model()->index(std::min(row, m_table->rowCount() - 1), CaseName);
        m_table->selectionModel()->setCurrentIndex(index, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    }
    say();
    choose();
}

void KeptRunsDialog::say() {
    QMap<QString, qint64> cases;
    qint64 all = 0;
    for (const KeptRunLine& line : m_lines) {
        cases[line.casePath] += line.bytes;
        all += line.bytes;
    }
    const QString cap = m_capGib > 0 ? tr("Preferences allow %1 GiB a case.").arg(m_capGib) : tr("Preferences keep no new runs.");
    if (m_lines.empty()) {
        m_total->setText(tr("No runs are kept. %1").arg(cap));
        return;
    }
    const auto most = std::max_element(cases.begin(), cases.end());
    QString text = tr("%1 in all; runs: %2, cases: %3. %4")
                       .arg(shownSize(all), shownCount(static_cast<std::int64_t>(m_lines.size())), shownCount(cases.size()), cap);
    if (cases.size() > 1 && !most.key().isEmpty()) {
        text += u' ' + tr("Most has %1: %2.").arg(QFileInfo(most.key()).fileName(), shownSize(most.value()));
    }
    m_total->setText(text);
}

std::vector<const KeptRunLine*> KeptRunsDialog::chosen() const {
    std::vector<const KeptRunLine*> lines;
    const QModelIndexList rows = m_table->selectionModel()->selectedRows();
    for (const QModelIndex& index : rows) {
        lines.push_back(&m_lines[static_cast<std::size_t>(index.row())]);
    }
    return lines;
}

void KeptRunsDialog::choose() {
    const std::vector<const KeptRunLine*> lines = chosen();
    const bool busy = std::any_of(lines.begin(), lines.end(), [](const KeptRunLine* line) { return line->busy; });
    const bool shown = std::any_of(lines.begin(), lines.end(), [](const KeptRunLine* line) { return line->shown; });
    const bool one = lines.size() == 1;
    m_remove->setEnabled(!lines.empty() && !busy && !shown);
    m_open->setEnabled(one && !busy && !shown && !lines.front()->casePath.isEmpty() && QFileInfo::exists(lines.front()->casePath));
    const QString why = busy                                       ? tr("Another program writes it.")
                        : shown                                    ? tr("It is in the views, so it stays.")
                        : one && lines.front()->casePath.isEmpty() ? tr("It is not known which case it belongs to.")
                        : one && !QFileInfo::exists(lines.front()->casePath)
                            ? tr("%1 is not there any more.").arg(lines.front()->casePath)
                            : QString();
    const QString what =
        lines.empty() ? QString()
        : one         ? lines.front()->path
                      : tr("Selected: %1, %2").arg(shownCount(static_cast<std::int64_t>(lines.size())), shownSize(sizeOf(lines)));
    m_details->setText(why.isEmpty() ? what : what + u'\n' + why);
}

void KeptRunsDialog::openChosen() {
    if (m_open->isEnabled()) {
        emit openRequested(chosen().front()->path);
    }
}

void KeptRunsDialog::remove() {
    const std::vector<const KeptRunLine*> lines = chosen();
    QStringList paths;
    for (const KeptRunLine* line : lines) {
        paths << line->path;
    }
    const QString what = lines.size() == 1 ? tr("Remove the run of %1 that ended %2?")
                                                 .arg(caseName(*lines.front()),
                                                      QLocale().toString(lines.front()->when.toLocalTime(), QLocale::ShortFormat))
                                           : tr("Remove %1 runs?").arg(shownCount(static_cast<std::int64_t>(lines.size())));
    QMessageBox ask(QMessageBox::Question, tr("Kept runs"), what, QMessageBox::Cancel, this);
    ask.setInformativeText(
        tr("%1 become free. Undo brings it back as long as the list is open; the entry in the history of the case stays.")
            .arg(shownSize(sizeOf(lines))));
    auto* agree = ask.addButton(tr("Remove"), QMessageBox::DestructiveRole);
    ask.setDefaultButton(QMessageBox::Cancel);
    ask.exec();
    if (ask.clickedButton() == agree) {
        emit removeRequested(paths);
    }
}

}  // namespace rubble::widgets
