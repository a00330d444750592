#include "app/gui/accuracy/error_display.h"

#include <QFileInfo>
#include <QLocale>

#include "app/gui/session/session.h"
#include "app/gui/stage/view_area.h"
#include "widgets/accuracy/error_bar.h"

namespace rubble {

ErrorDisplay::ErrorDisplay(Session& session, ViewArea& area, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_computation(session.computation()),
      m_area(area),
      m_work(session.part<ReferenceWork>()),
      m_kept(session.part<Kept>()) {
    widgets::ErrorBar& bar = m_area.errorBar();
    connect(&bar, &widgets::ErrorBar::computeRequested, this, &ErrorDisplay::compute);
    connect(&bar, &widgets::ErrorBar::cancelRequested, &m_work, &ReferenceWork::cancel);
    connect(&m_work, &ReferenceWork::progressed, &bar, &widgets::ErrorBar::setProgress);
    connect(&m_work, &ReferenceWork::changed, this, [this] {
        showBar();
        emit changed();
    });
    connect(&m_work, &ReferenceWork::ended, this, [this](const Failure* failure) {
        m_kept.failure = failure != nullptr ? std::optional(*failure) : std::nullopt;
        showBar();
        emit changed();
    });
    m_work.tellProgress();
}

std::shared_ptr<const TrajectoryReader> ErrorDisplay::reference() const {
    return m_shown && m_computation.currentRun() != nullptr ? m_work.reader() : nullptr;
}

void ErrorDisplay::setShown(bool shown) {
    if (shown != m_shown) {
        m_shown = shown;
        refresh();
        emit changed();
    }
}

void ErrorDisplay::setBusy(const QString& why) {
    if (why != m_busy) {
        m_busy = why;
        showBar();
    }
}

void ErrorDisplay::refresh() {
    const RunRecord* record = m_computation.currentRun();
    if (m_shown && record != nullptr && m_computation.inputs().fe != nullptr) {
        m_work.look(m_computation.inputs(), record->scenario);
    } else if (record == nullptr && m_work.reader() != nullptr) {
        m_work.clear();
    }
    showBar();
}

void ErrorDisplay::compute() {
    const RunRecord* record = m_computation.currentRun();
    if (record == nullptr || record->running || record->reader == nullptr || !m_busy.isEmpty()) {
        return;
    }
    m_kept.failure.reset();
    m_work.start(m_computation.inputs(), record->scenario, record->reader->origin());
    showBar();
    emit changed();
}

void ErrorDisplay::showBar() {
    using State = widgets::ErrorBar::State;
    widgets::ErrorBar& bar = m_area.errorBar();
    bar.setVisible(m_shown);
    const RunRecord* record = m_computation.currentRun();
    if (record == nullptr) {
        bar.setState(State::NoRun);
    } else if (m_work.running()) {
        bar.setState(State::Computing);
    } else if (m_work.reader() != nullptr) {
        const double megabytes = static_cast<double>(QFileInfo(QString::fromStdString(m_work.reader()->path())).size()) / 1e6;
        bar.setState(State::Shown, tr("The reference is kept (%1 MB).").arg(QLocale().toString(megabytes, 'f', 0)));
    } else if (m_kept.failure) {
        bar.setState(State::Failed, m_kept.failure->inOneLine());
    } else if (record->running || !m_busy.isEmpty()) {
        bar.setState(State::Waiting, record->running ? tr("It can be computed when the run is through.") : m_busy);
    } else {
        bar.setState(State::NoReference);
    }
}

}  // namespace rubble
