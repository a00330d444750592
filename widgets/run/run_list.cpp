#include "widgets/run/run_list.h"

#include <QDateTime>
#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/case/run_verdict.h"

namespace rubble::widgets {

namespace {

QString shownTime(const RunEntry& run) {
    const QDateTime when = QDateTime::fromString(QString::fromStdString(run.when), Qt::ISODate);
    return when.isValid() ? QLocale().toString(when.toLocalTime(), QLocale::ShortFormat) : QString::fromStdString(run.when);
}

}  // namespace

RunList::RunList(QWidget* parent)
    : QWidget(parent),
      m_none(new QLabel(tr("Every run of this case is listed here: when, what with, and what came of it."))),
      m_list(new QListWidget),
      m_details(new QLabel),
      m_show(new QPushButton(tr("Show this run"))) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    m_none->setObjectName(QStringLiteral("muted"));
    m_none->setWordWrap(true);
    column->addWidget(m_none);
    m_list->setObjectName(QStringLiteral("runList"));
    m_list->setAccessibleName(tr("Runs of this case"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setWordWrap(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setFont(headingFont());
    column->addWidget(m_list);
    m_details->setObjectName(QStringLiteral("muted"));
    m_details->setFont(headingFont());
    m_details->setWordWrap(true);
    m_details->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_details);
    m_show->setObjectName(QStringLiteral("showRun"));
    column->addWidget(m_show, 0, Qt::AlignLeft);
    connect(m_list, &QListWidget::currentRowChanged, this, &RunList::choose);
    connect(m_list, &QListWidget::itemActivated, this, [this] {
        if (m_show->isEnabled()) {
            m_show->click();
        }
    });
    connect(m_show, &QPushButton::clicked, this, [this] {
        if (m_list->currentRow() >= 0) {
            emit showRequested(placeOf(m_list->currentRow()));
        }
    });
    setContent({});
}

void RunList::setContent(std::vector<Line> lines) {
    const bool longer = lines.size() != m_lines.size();
    if (lines == m_lines && m_list->count() == static_cast<int>(lines.size()) && !lines.empty()) {
        return;
    }
    m_lines = std::move(lines);
    list(longer ? 0 : m_list->currentRow());
}

void RunList::setSimulating(bool simulating) {
    if (std::exchange(m_simulating, simulating) != simulating) {
        choose();
    }
}

void RunList::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    // Dates are written as the language has them.
    if (event->type() == QEvent::LanguageChange) {
        list(m_list->currentRow());
    }
}

void RunList::list(int row) {
    m_list->clear();
    for (std::size_t i = m_lines.size(); i-- > 0;) {
        const RunEntry& run = m_lines[i].run;
        QString text = tr("%1 · %2").arg(shownTime(run), QString::fromStdString(run.scenarioName)) + u'\n';
        text += tr("%1 bodies · %2 · %3").arg(shownCount(run.bodies), shownDuration(run.wallSeconds), runVerdict(run));
        if (m_lines[i].shown) {
            text += QStringLiteral(" · ") + tr("shown");
        }
        auto* item = new QListWidgetItem(text, m_list);
        item->setToolTip(m_lines[i].fileThere ? QString::fromStdString(run.file) : QString());
    }
    m_none->setVisible(m_lines.empty());
    m_list->setVisible(!m_lines.empty());
    const int shown = std::clamp(static_cast<int>(m_lines.size()), 1, 4);
    m_list->setFixedHeight(shown * (2 * m_list->fontMetrics().lineSpacing() + 10) + 4);
    if (!m_lines.empty()) {
        m_list->setCurrentRow(std::clamp(row, 0, m_list->count() - 1));
    }
    choose();
}

int RunList::count() const {
    return m_list->count();
}

void RunList::choose() {
    const int row = m_list->currentRow();
    const bool have = row >= 0 && !m_lines.empty();
    m_details->setVisible(have);
    m_show->setVisible(have);
    if (!have) {
        return;
    }
    const Line& line = m_lines[placeOf(row)];
    const RunEntry& run = line.run;
    QStringList parts;
    parts << tr("Fingerprint %1").arg(QString::fromStdString(run.fingerprint.hex()).left(8));
    if (run.complete) {
        parts << tr("trajectory %1").arg(QString::fromStdString(run.trajectoryHash.hex()).left(8));
    }
    parts << (run.live ? tr("live") : tr("as fast as it went"));
    // A button that cannot be pushed shows no tip.
    const QString why = line.shown         ? QString()
                        : run.file.empty() ? tr("Its file was not kept, so it cannot be shown.")
                        : !line.fileThere
                            ? tr("%1 is not there any more, so it cannot be shown.").arg(QString::fromStdString(run.file))
                        : m_simulating ? tr("A run is being simulated: this one can be shown when that has ended.")
                                       : QString();
    m_details->setText(parts.join(QStringLiteral(" · ")) + (why.isEmpty() ? QString() : u'\n' + why));
    m_details->setToolTip(tr("Fingerprint of inputs, settings and program: %1\nTrajectory of every recorded frame: %2\nProgram: %3")
                              .arg(QString::fromStdString(run.fingerprint.hex()), QString::fromStdString(run.trajectoryHash.hex()),
                                   QString::fromStdString(run.build)));
    m_show->setEnabled(why.isEmpty() && !line.shown);
    m_show->setToolTip(line.shown ? tr("It is the run in the views")
                       : !why.isEmpty()
                           ? why
                           : tr("Open %1 and show it in the views").arg(QFileInfo(QString::fromStdString(run.file)).fileName()));
}

}  // namespace rubble::widgets
