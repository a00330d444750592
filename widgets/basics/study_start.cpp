#include "widgets/basics/study_start.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/basics/place_choice.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

ProgressLabel::ProgressLabel(QWidget* parent) : QLabel(parent) {
    m_second.setInterval(1000);
    connect(&m_second, &QTimer::timeout, this, &ProgressLabel::tell);
}

void ProgressLabel::setProgress(const QString& what, double secondsLeft) {
    m_what = what;
    m_left = secondsLeft;
    m_since.start();
    if (std::isfinite(secondsLeft)) {
        m_second.start();
    } else {
        m_second.stop();
    }
    tell();
}

void ProgressLabel::setPlain(const QString& text) {
    m_second.stop();
    setText(text);
}

void ProgressLabel::hideEvent(QHideEvent* event) {
    m_second.stop();
    QLabel::hideEvent(event);
}

void ProgressLabel::tell() {
    constexpr double patience = 2.0;  // s over the estimate before that is said
    const double left = m_left - static_cast<double>(m_since.elapsed()) / 1000.0;
    const QString text = shownProgress(m_what, left);
    setText(left < -patience ? text + tr(" · takes longer than estimated") : text);
}

StudyStart::StudyStart(const Words& words, PlaceChoice* place, QWidget* parent)
    : QWidget(parent),
      m_start(new QPushButton(words.start)),
      m_cancel(new QPushButton(tr("Cancel"))),
      m_place(place),
      m_why(new QLabel),
      m_bar(new QProgressBar),
      m_progress(new ProgressLabel) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    m_start->setObjectName(QStringLiteral("primary"));
    m_start->setToolTip(words.startTip);
    m_cancel->setObjectName(words.cancelId);
    m_cancel->setToolTip(words.cancelTip);
    m_bar->setTextVisible(false);
    m_bar->setRange(0, 1000);
    m_bar->setAccessibleName(words.bar);
    for (QLabel* label : {m_why, static_cast<QLabel*>(m_progress)}) {
        label->setObjectName(QStringLiteral("muted"));
        label->setWordWrap(true);
    }
    column->addWidget(m_start);
    column->addWidget(m_cancel);
    if (m_place != nullptr) {
        column->addWidget(m_place);
    }
    column->addWidget(m_why);
    column->addWidget(m_bar);
    column->addWidget(m_progress);
    connect(m_start, &QPushButton::clicked, this, &StudyStart::startRequested);
    connect(m_cancel, &QPushButton::clicked, this, &StudyStart::cancelRequested);
    setReady(false, false, {});
}

void StudyStart::setReady(bool ready, bool running, const QString& why) {
    m_start->setEnabled(ready && !running);
    m_start->setVisible(!running);
    m_cancel->setVisible(running);
    m_bar->setVisible(running);
    m_progress->setVisible(running);
    if (m_place != nullptr) {
        m_place->setEnabled(!running);
    }
    m_why->setText(why);
    m_why->setVisible(!why.isEmpty());
}

void StudyStart::setProgress(const QString& what, double fraction, double secondsLeft) {
    m_bar->setValue(static_cast<int>(std::lround(1000.0 * fraction)));
    m_progress->setProgress(what, secondsLeft);
}

void StudyStart::start() {
    m_start->click();
}

}  // namespace rubble::widgets
