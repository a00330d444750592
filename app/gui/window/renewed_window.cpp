#include "app/gui/window/renewed_window.h"

#include <QApplication>
#include <QThread>

#include "app/gui/session/session.h"
#include "app/gui/window/main_window.h"
#include "widgets/basics/language.h"
#include "widgets/basics/theme.h"

namespace rubble {

namespace {

constexpr int lookEvery = 100;  // ms

std::unique_ptr<MainWindow> made(Session& session) {
    // A window is made from its parts upwards. Under a style sheet each step would style all below anew; it puts on its own at
    // last.
    widgets::takeOffSheet();
    return std::make_unique<MainWindow>(session);
}

}  // namespace

RenewedWindow::RenewedWindow(Session& session, QObject* parent) : QObject(parent), m_session(session), m_window(made(session)) {
    m_wait.setSingleShot(true);
    connect(&m_wait, &QTimer::timeout, this, &RenewedWindow::preferencesChanged);
    connect(&session, &Session::preferencesChanged, this, [this](const widgets::Preferences& before) {
        const widgets::Preferences& now = m_session.preferences();
        if (now.language != before.language) {
            m_language = now.language;
        }
        if (now.language != before.language || now.units != before.units) {
            // Whoever changed them may belong to the window that goes.
            m_wait.start(0);
        }
    });
}

RenewedWindow::~RenewedWindow() = default;

bool RenewedWindow::mayGo() const {
    return QApplication::activeModalWidget() == nullptr && QThread::currentThread()->loopLevel() <= 1 &&
           m_window->rooms().opening->caseInTheMaking() == nullptr;
}

void RenewedWindow::preferencesChanged() {
    if (mayGo()) {
        speak(m_language.isEmpty() ? widgets::currentLanguage() : m_language);
    } else {
        m_wait.start(lookEvery);
    }
}

void RenewedWindow::speak(const QString& language) {
    const QString wanted = language;
    const bool visible = m_window->isVisible();
    // For a moment there is no window; the program does not end for that.
    const bool quits = QGuiApplication::quitOnLastWindowClosed();
    QGuiApplication::setQuitOnLastWindowClosed(false);
    m_language.clear();
    m_window.reset();
    widgets::speak(wanted);
    m_session.document().nameEdits();
    m_window = made(m_session);
    if (visible) {
        m_window->show();
        m_window->activateWindow();
        m_window->openAgain();
    }
    QGuiApplication::setQuitOnLastWindowClosed(quits);
    emit renewed();
}

}  // namespace rubble
