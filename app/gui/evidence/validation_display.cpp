#include "app/gui/evidence/validation_display.h"

#include <QVBoxLayout>
#include <limits>

#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "widgets/evidence/validation_view.h"

namespace rubble {

ValidationDisplay::ValidationDisplay(Session& session, Actions& actions, QWidget& window, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_work(session.part<ValidationWork>()),
      m_kept(session.part<Kept>()),
      m_dialog(new QDialog(&window)),
      m_view(new widgets::ValidationView) {
    m_dialog->setWindowTitle(tr("Validation"));
    m_dialog->setModal(false);
    m_dialog->resize(980, 640);
    m_dialog->setProperty("help", QStringLiteral("Validation"));
    auto* column = new QVBoxLayout(m_dialog);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_view);
    connect(&actions[ActionId::Validation], &QAction::triggered, this, &ValidationDisplay::open);
    connect(&m_work, &ValidationWork::changed, this, &ValidationDisplay::refresh);
    connect(&m_work, &ValidationWork::progressed, this, [this](const QString& set, double fraction, double secondsLeft) {
        m_view->setProgress(tr("Simulating the falls of %1").arg(set), fraction, secondsLeft);
    });
    connect(&m_work, &ValidationWork::ended, this, &ValidationDisplay::ended);
    connect(m_view, &widgets::ValidationView::validateRequested, this, &ValidationDisplay::start);
    connect(m_view, &widgets::ValidationView::cancelRequested, &m_work, &ValidationWork::cancel);
    if (m_kept.open) {
        open();
    }
}

ValidationDisplay::~ValidationDisplay() {
    m_kept.open = m_dialog->isVisible();
}

void ValidationDisplay::open() {
    if (!m_work.running()) {
        m_work.load();
    }
    refresh();
    m_dialog->show();
    m_dialog->raise();
    m_dialog->activateWindow();
}

void ValidationDisplay::start() {
    if (!m_busy.isEmpty()) {
        m_view->setError(m_busy);
        return;
    }
    m_kept.failure.reset();
    m_work.start();
    m_view->setProgress(tr("Reading the sets"), 0.0, std::numeric_limits<double>::quiet_NaN());
    refresh();
    emit changed();
}

void ValidationDisplay::ended(const Failure* failure) {
    m_kept.failure = failure != nullptr ? std::optional(*failure) : std::nullopt;
    if (failure == nullptr) {
        m_session.tell(tr("Validation has ended; sets that are done are kept"));
    }
    refresh();
    emit changed();
}

void ValidationDisplay::refresh() {
    m_view->setError(m_kept.failure ? m_kept.failure->what() : QString(), m_kept.failure ? m_kept.failure->remedy() : QString());
    m_view->setContent({m_work.records(), m_work.findings(), m_work.running()});
}

}  // namespace rubble
