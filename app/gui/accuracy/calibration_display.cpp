#include "app/gui/accuracy/calibration_display.h"

#include <QVBoxLayout>
#include <limits>

#include "app/gui/session/session.h"
#include "app/gui/stage/panel_deck.h"
#include "widgets/accuracy/calibration_view.h"

namespace rubble {

CalibrationDisplay::CalibrationDisplay(Session& session, PanelDeck& deck, QWidget& window, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_document(session.document()),
      m_deck(deck),
      m_work(session.part<CalibrationWork>()),
      m_kept(session.part<Kept>()),
      m_dialog(new QDialog(&window)),
      m_view(new widgets::CalibrationView) {
    m_dialog->setWindowTitle(tr("This machine"));
    m_dialog->setModal(false);
    m_dialog->resize(760, 620);
    auto* column = new QVBoxLayout(m_dialog);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_view);
    connect(&m_work, &CalibrationWork::changed, this, &CalibrationDisplay::refresh);
    connect(&m_work, &CalibrationWork::progressed, m_view, &widgets::CalibrationView::setProgress);
    connect(&m_work, &CalibrationWork::ended, this, &CalibrationDisplay::ended);
    connect(m_view, &widgets::CalibrationView::calibrateRequested, this, &CalibrationDisplay::calibrate);
    connect(m_view, &widgets::CalibrationView::cancelRequested, &m_work, &CalibrationWork::cancel);
    connect(m_view, &widgets::CalibrationView::bodiesChosen, this, [this](std::int64_t bodies) {
        if (!m_document.empty()) {
            m_document.setParameter(QStringLiteral("bodies_max"), ParameterValue(bodies));
        }
    });
    connect(&m_deck.grid(), &widgets::GridPanel::calibrationRequested, this, &CalibrationDisplay::open);
    connect(&m_deck.accuracy(), &widgets::AccuracyPanel::calibrationRequested, this, &CalibrationDisplay::open);
    connect(&m_document, &Document::scenarioChanged, this, &CalibrationDisplay::targetChanged);
    connect(&m_document, &Document::replaced, this, &CalibrationDisplay::targetChanged);
    targetChanged();
    showFailure();
    refresh();
    m_work.tellProgress();
    if (m_kept.open) {
        open();
    }
}

CalibrationDisplay::~CalibrationDisplay() {
    m_kept.open = m_dialog->isVisible();
}

void CalibrationDisplay::showFailure() {
    m_view->setError(m_kept.failure ? m_kept.failure->what() : QString(), m_kept.failure ? m_kept.failure->remedy() : QString());
}

void CalibrationDisplay::open() {
    refresh();
    m_dialog->show();
    m_dialog->raise();
    m_dialog->activateWindow();
}

void CalibrationDisplay::setBusy(const QString& why) {
    if (why != m_busy) {
        m_busy = why;
        refresh();
    }
}

void CalibrationDisplay::targetChanged() {
    const double target = m_document.scenario().grid.fpsTarget;
    if (target != m_kept.target) {
        m_kept.target = target;
        m_work.load(target);
        refresh();
    } else if (m_dialog->isVisible()) {
        refresh();
    }
}

void CalibrationDisplay::calibrate() {
    if (m_work.running() || !m_busy.isEmpty()) {
        return;
    }
    m_kept.failure.reset();
    showFailure();
    m_kept.before = m_work.calibration().get();
    m_work.start(m_kept.target);
    m_view->setProgress(0.0, std::numeric_limits<double>::quiet_NaN());
    refresh();
    emit changed();
}

void CalibrationDisplay::ended(const Failure* failure) {
    m_kept.failure = failure != nullptr ? std::optional(*failure) : std::nullopt;
    showFailure();
    if (failure == nullptr) {
        m_session.tell(m_work.calibration().get() != m_kept.before ? tr("This machine is calibrated")
                                                                   : tr("The calibration was cancelled"));
    }
    refresh();
    emit changed();
}

void CalibrationDisplay::refresh() {
    const Calibration* calibration = m_work.calibration().get();
    widgets::GridPanel::MachineAdvice advice;
    advice.target = m_kept.target;
    if (calibration != nullptr) {
        advice.calibrated = true;
        advice.disturbed = calibration->disturbed();
        advice.typical = m_work.plot().bodiesMax[static_cast<std::size_t>(PileKind::Typical)];
        advice.worst = m_work.plot().bodiesMax[static_cast<std::size_t>(PileKind::Worst)];
    }
    m_deck.grid().setAdvice(advice);
    widgets::CalibrationView::Content content;
    content.calibration = m_work.calibration();
    content.plot = m_work.plot();
    content.bodiesMax = m_document.empty() ? 0 : m_document.scenario().grid.bodiesMax;
    content.running = m_work.running();
    content.why = m_busy;
    m_view->setContent(content);
}

}  // namespace rubble
