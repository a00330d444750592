#include "widgets/views/status_line.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <cmath>

#include "widgets/basics/theme.h"

namespace rubble::widgets {

StatusLine::StatusLine(QWidget* parent)
    : QWidget(parent), m_activity(new QLabel), m_progress(new QProgressBar), m_cancel(new QPushButton(tr("Cancel"))) {
    setObjectName(QStringLiteral("statusLine"));
    setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 2, 12, 2);
    row->setSpacing(16);
    m_progress->setTextVisible(false);
    m_progress->setFixedWidth(96);
    m_progress->setRange(0, 1000);
    m_progress->setAccessibleName(tr("Progress"));
    m_cancel->setToolTip(tr("Stop what runs (Esc); what is computed so far stays"));
    m_cancel->setObjectName(QStringLiteral("cancel"));
    m_cancel->setStyleSheet(QStringLiteral("padding: 1px 8px;"));
    // In front of sentences of any length, so that it stands still.
    row->addWidget(m_cancel);
    row->addWidget(m_progress);
    row->addWidget(m_activity);
    for (std::size_t i = 0; i < m_figures.size(); ++i) {
        m_figures[i] = new QLabel;
        m_figures[i]->setTextFormat(Qt::RichText);
        if (static_cast<Figure>(i) == Figure::Memory) {
            row->addStretch();
        }
        row->addWidget(m_figures[i]);
        m_figures[i]->hide();
        connect(m_figures[i], &QLabel::linkActivated, this, [this, i] { emit figureChosen(static_cast<Figure>(i)); });
    }
    m_activity->hide();
    m_progress->hide();
    m_cancel->hide();
    setFixedHeight(fontMetrics().height() + 16);
    connect(m_cancel, &QPushButton::clicked, this, &StatusLine::cancelRequested);
}

void StatusLine::setActivity(const QString& what, double fraction) {
    m_running = !what.isEmpty();
    m_activity->setText(m_running ? what : m_message);
    m_activity->setVisible(!m_activity->text().isEmpty());
    m_progress->setVisible(m_running);
    m_cancel->setVisible(m_running);
    if (fraction < 0.0) {
        m_progress->setRange(0, 0);
    } else {
        m_progress->setRange(0, 1000);
        m_progress->setValue(static_cast<int>(std::lround(1000.0 * std::min(1.0, fraction))));
    }
    makeRoom();
}

void StatusLine::setMessage(const QString& message) {
    m_message = message;
    if (!m_running) {
        m_activity->setText(message);
        m_activity->setVisible(!message.isEmpty());
    }
    makeRoom();
}

void StatusLine::setFigure(Figure figure, const QString& name, const QString& value, const QString& aside, bool warns) {
    QLabel* label = m_figures[static_cast<std::size_t>(figure)];
    QString text = QStringLiteral("%1 <b>%2</b>").arg(name.toHtmlEscaped(), value.toHtmlEscaped());
    if (!aside.isEmpty()) {
        text += QStringLiteral(" <span style='color:%1'>%2</span>").arg(tints().muted.name(), aside.toHtmlEscaped());
    }
    if (warns || figure == Figure::Findings) {
        text = QStringLiteral("<span style='color:%1'>%2</span>").arg(tints().finding.name(), text);
    }
    if (figure == Figure::Findings || figure == Figure::Health) {
        const QColor colour = warns || figure == Figure::Findings ? tints().finding : tints().text;
        text = QStringLiteral("<a href='figure' style='color:%1;text-decoration:none'>%2</a>").arg(colour.name(), text);
    }
    label->setText(text);
    m_wanted[static_cast<std::size_t>(figure)] = !value.isEmpty();
    makeRoom();
}

void StatusLine::makeRoom() {
    constexpr std::array missed{Figure::Playback, Figure::Energy, Figure::Step, Figure::Memory, Figure::Live};
    const int spacing = layout()->spacing();
    int need = layout()->contentsMargins().left() + layout()->contentsMargins().right();
    for (const QWidget* each : {static_cast<const QWidget*>(m_cancel), static_cast<const QWidget*>(m_progress),
                                static_cast<const QWidget*>(m_activity)}) {
        need += each->isHidden() ? 0 : each->sizeHint().width() + spacing;
    }
    std::array<bool, 8> shown = m_wanted;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        need += shown[i] ? m_figures[i]->sizeHint().width() + spacing : 0;
    }
    for (const Figure figure : missed) {
        const auto i = static_cast<std::size_t>(figure);
        if (need > width() && shown[i]) {
            shown[i] = false;
            need -= m_figures[i]->sizeHint().width() + spacing;
        }
    }
    for (std::size_t i = 0; i < shown.size(); ++i) {
        m_figures[i]->setVisible(shown[i]);
    }
}

QSize StatusLine::minimumSizeHint() const {
    constexpr int least = 320;  // px
    return {least, QWidget::minimumSizeHint().height()};
}

void StatusLine::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    makeRoom();
}

void StatusLine::setFigureTip(Figure figure, const QString& tip) {
    m_figures[static_cast<std::size_t>(figure)]->setToolTip(tip);
}

QString StatusLine::figureText(Figure figure) const {
    const QLabel* label = m_figures[static_cast<std::size_t>(figure)];
    return m_wanted[static_cast<std::size_t>(figure)] ? label->text() : QString();
}

QString StatusLine::activityText() const {
    return m_activity->text();
}

}  // namespace rubble::widgets
