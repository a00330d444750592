#include "widgets/accuracy/calibration_view.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/accuracy/calibration_chart.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/study_start.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

CalibrationView::CalibrationView(QWidget* parent)
    : QWidget(parent),
      m_sentence(new QLabel),
      m_notice(new Notice),
      m_chart(new CalibrationChart),
      m_facts(new QLabel),
      m_calibrate(new QPushButton(tr("Calibrate this machine"))),
      m_cancel(new QPushButton(tr("Cancel"))),
      m_use(new QPushButton),
      m_saveTable(new QPushButton(tr("Save table…"))),
      m_saveChart(new QPushButton(tr("Save chart…"))),
      m_bar(new QProgressBar),
      m_progress(new ProgressLabel),
      m_findings(new FindingList) {
    setObjectName(QStringLiteral("panelBody"));
    setAttribute(Qt::WA_StyledBackground);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 12, 16, 12);
    column->setSpacing(8);
    auto* title = new QLabel(tr("What this machine carries"));
    title->setFont(titleFont());
    column->addWidget(title);
    m_sentence->setObjectName(QStringLiteral("muted"));
    m_sentence->setWordWrap(true);
    column->addWidget(m_sentence);
    column->addWidget(m_notice);
    column->addWidget(m_findings);
    column->addWidget(m_chart, 1);
    m_facts->setWordWrap(true);
    m_facts->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_facts->setObjectName(QStringLiteral("calibrationFacts"));
    column->addWidget(m_facts);
    m_bar->setTextVisible(false);
    m_bar->setRange(0, 1000);
    m_bar->setAccessibleName(tr("Progress of the calibration"));
    column->addWidget(m_bar);
    m_progress->setObjectName(QStringLiteral("muted"));
    column->addWidget(m_progress);
    column->addWidget(buildButtons());
    m_calibrate->setFocus();
    setContent({});
}

QWidget* CalibrationView::buildButtons() {
    auto* buttons = new QWidget;
    auto* row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    m_calibrate->setObjectName(QStringLiteral("primary"));
    m_calibrate->setToolTip(
        tr("Simulates and draws piles of several sizes, one after the other; takes some minutes. Let the machine "
           "rest meanwhile"));
    m_cancel->setObjectName(QStringLiteral("cancelCalibration"));
    m_cancel->setToolTip(tr("Stop measuring; what was kept before stays"));
    m_use->setObjectName(QStringLiteral("useBodies"));
    m_use->setToolTip(tr("The case allows as many bodies as a typical pile may have at the target rate; one step of undo"));
    m_saveTable->setToolTip(tr("Save the measured points as CSV, with the columns of rubble-cli calibrate"));
    m_saveChart->setToolTip(tr("Save the chart as SVG or PNG"));
    row->addWidget(m_calibrate);
    row->addWidget(m_cancel);
    row->addWidget(m_use);
    row->addStretch();
    row->addWidget(m_saveTable);
    row->addWidget(m_saveChart);
    connect(m_calibrate, &QPushButton::clicked, this, &CalibrationView::calibrateRequested);
    connect(m_cancel, &QPushButton::clicked, this, &CalibrationView::cancelRequested);
    connect(m_use, &QPushButton::clicked, this, [this] { emit bodiesChosen(m_offered); });
    connect(m_saveTable, &QPushButton::clicked, this, &CalibrationView::saveTableRequested);
    connect(m_saveChart, &QPushButton::clicked, this, &CalibrationView::saveChartRequested);
    return buttons;
}

void CalibrationView::setContent(const Content& content) {
    const Calibration* calibration = content.calibration.get();
    m_sentence->setText(
        calibration == nullptr
            ? tr("How many frames per second live mode reaches with so many bodies. Squares are the published points, measured on "
                 "a "
                 "GTX 480 in 2012.")
            : tr("%1; simulated on %2 threads, drawn by %3. A frame simulates 1/%4 s of the collapse and draws both views. "
                 "Typical: "
                 "the mean of a pile that comes to rest. Worst: the worst second of a heap of which nothing ever rests. Both are "
                 "fragments alone: whole spans that the engine moves (loose_structure) come on top.")
                  .arg(QString::fromStdString(calibration->machine), shownCount(calibration->threads),
                       calibration->renderer.empty() ? tr("nothing") : QString::fromStdString(calibration->renderer),
                       QLocale().toString(calibration->target, 'g', 4)));
    if (!m_failed) {
        m_notice->set(Notice::Kind::Note,
                      calibration == nullptr && !content.running ? tr("This machine was not calibrated yet.") : QString(),
                      tr("Until then the bodies allowed are the published 4,500 at 24 FPS, and nothing is predicted of a collapse "
                         "that was not compared."));
    }
    m_findings->set(calibration != nullptr ? calibration->findings : Findings());
    m_chart->setContent(content.plot);
    showFacts(content);
    m_calibrate->setText(calibration == nullptr ? tr("Calibrate this machine") : tr("Calibrate again"));
    m_calibrate->setVisible(!content.running);
    m_calibrate->setEnabled(content.why.isEmpty());
    m_cancel->setVisible(content.running);
    m_bar->setVisible(content.running);
    m_progress->setVisible(content.running || !content.why.isEmpty());
    if (!content.running) {
        m_progress->setPlain(content.why);
    }
    m_saveTable->setEnabled(calibration != nullptr);
}

void CalibrationView::showFacts(const Content& content) {
    QStringList lines;
    m_offered = 0;
    if (content.calibration != nullptr) {
        for (const PileKind pile : {PileKind::Typical, PileKind::Worst}) {
            const auto& most = content.plot.bodiesMax[static_cast<std::size_t>(pile)];
            const QString name = curveWords(pile, LiveLoad::Both);
            lines << (most ? tr("%1: %2 bodies at %3 FPS")
                                 .arg(name, bodiesWords(*most), QLocale().toString(content.plot.target, 'g', 4))
                           : tr("%1: not known, fewer than three points").arg(name));
        }
        const auto& typical = content.plot.bodiesMax[static_cast<std::size_t>(PileKind::Typical)];
        m_offered = typical && !content.calibration->disturbed() ? roundedBodies(*typical) : 0;
    }
    m_facts->setText(lines.join(QStringLiteral("  ·  ")));
    m_facts->setVisible(!lines.isEmpty());
    m_use->setText(tr("Allow %1 bodies").arg(shownCount(m_offered)));
    m_use->setVisible(!content.running && m_offered > 0 && content.bodiesMax > 0 && m_offered != content.bodiesMax);
}

void CalibrationView::setProgress(double fraction, double secondsLeft) {
    m_bar->setValue(static_cast<int>(std::lround(1000.0 * fraction)));
    m_progress->setProgress(tr("Measuring this machine"), secondsLeft);
}

void CalibrationView::setError(const QString& what, const QString& remedy) {
    m_failed = !what.isEmpty();
    m_notice->set(Notice::Kind::Error, what, remedy);
}

}  // namespace rubble::widgets
