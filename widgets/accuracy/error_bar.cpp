#include "widgets/accuracy/error_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <cmath>

#include "widgets/basics/study_start.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

ErrorBar::ErrorBar(QWidget* parent)
    : QFrame(parent),
      m_words(new ProgressLabel),
      m_bar(new QProgressBar),
      m_compute(new QPushButton(tr("Compute the reference"))),
      m_cancel(new QPushButton(tr("Cancel"))) {
    setObjectName(QStringLiteral("bottom"));
    setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 6, 12, 6);
    row->setSpacing(10);
    m_words->setWordWrap(true);
    row->addWidget(m_words, 1);
    m_bar->setTextVisible(false);
    m_bar->setRange(0, 1000);
    m_bar->setFixedWidth(160);
    m_bar->setAccessibleName(tr("Progress of the reference"));
    row->addWidget(m_bar);
    m_compute->setObjectName(QStringLiteral("computeReference"));
    m_compute->setToolTip(
        tr("Simulates the same collapse with a body for every fragment and keeps it; takes several times as long as "
           "the run"));
    m_cancel->setObjectName(QStringLiteral("cancelReference"));
    row->addWidget(m_compute);
    row->addWidget(m_cancel);
    connect(m_compute, &QPushButton::clicked, this, &ErrorBar::computeRequested);
    connect(m_cancel, &QPushButton::clicked, this, &ErrorBar::cancelRequested);
    setState(State::NoRun);
}

void ErrorBar::setState(State state, const QString& words) {
    m_state = state;
    QString text;
    switch (state) {
        case State::NoRun:
            text = tr("Errors are not known: simulate first, then compare with a reference.");
            break;
        case State::NoReference:
        case State::Waiting:
            text = tr("Errors are not known: there is no reference of this run, in which every fragment is its own body.");
            break;
        case State::Computing:
            text = tr("Computing the reference");
            break;
        case State::Shown:
            text = tr("Coloured by the distance of each fragment from its place in the reference at the same time.");
            break;
        case State::Failed:
            text = tr("The reference could not be computed.");
            break;
    }
    m_words->setPlain(words.isEmpty() ? text : text + QLatin1Char(' ') + words);
    m_compute->setVisible(state == State::NoReference || state == State::Failed || state == State::Waiting);
    m_compute->setEnabled(state != State::Waiting);
    m_cancel->setVisible(state == State::Computing);
    m_bar->setVisible(state == State::Computing);
}

void ErrorBar::setProgress(double fraction, double secondsLeft) {
    if (m_state != State::Computing) {
        return;
    }
    m_bar->setValue(static_cast<int>(std::lround(1000.0 * fraction)));
    m_words->setProgress(tr("Computing the reference"), secondsLeft);
}

QString ErrorBar::text() const {
    return m_words->text();
}

}  // namespace rubble::widgets
