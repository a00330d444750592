#include "app/gui/window/done_notice.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QVariantMap>

#include "app/gui/session/session.h"
#include "app/gui/window/main_window.h"
#include "widgets/views/status_line.h"

namespace rubble {

namespace {

constexpr int lookEvery = 250;       // ms
constexpr int longWork = 10 * 1000;  // ms

}  // namespace

DoneNotice::DoneNotice(MainWindow& window)
    : DoneNotice(window, longWork,
                 [](const QString& what, const QString& about) { notifyDesktop(QDBusConnection::sessionBus(), what, about); }) {}

DoneNotice::DoneNotice(MainWindow& window, int longMs, Show show)
    : QObject(&window),
      m_window(window),
      m_longMs(longMs),
      m_show(std::move(show)),
      m_kept(window.session().part<Kept>()),
      m_since(m_kept.since) {
    connect(&m_timer, &QTimer::timeout, this, &DoneNotice::look);
    connect(&window.session().computation(), &Computation::stateChanged, this, &DoneNotice::look);
    m_timer.start(lookEvery);
}

bool DoneNotice::working() const {
    const WindowRooms& rooms = m_window.rooms();
    return m_window.session().computation().busy() || rooms.accuracy->work().running() || rooms.calibration->work().running() ||
           rooms.validation->work().running() || rooms.errors->work().running() || rooms.studies->work().running() ||
           rooms.survey->busy() || rooms.report->writing();
}

void DoneNotice::look() {
    if (working()) {
        if (!m_since.isValid()) {
            m_since.start();
            m_kept.since = m_since;
        }
        return;
    }
    const bool ended = m_since.isValid() && m_since.elapsed() >= m_longMs;
    m_since.invalidate();
    m_kept.since.invalidate();
    if (ended) {
        // By then the window has said what came of it.
        QTimer::singleShot(lookEvery, this, &DoneNotice::tell);
    }
}

void DoneNotice::tell() {
    if (QApplication::activeWindow() == nullptr) {
        QApplication::alert(&m_window);
        m_show(m_window.findChild<widgets::StatusLine*>()->activityText(),
               QString::fromStdString(m_window.session().document().theCase().title));
    }
}

void notifyDesktop(const QDBusConnection& bus, const QString& what, const QString& about) {
    if (!bus.isConnected() || what.isEmpty()) {
        return;
    }
    QDBusMessage message = QDBusMessage::createMethodCall(
        QStringLiteral("org.freedesktop.Notifications"), QStringLiteral("/org/freedesktop/Notifications"),
        QStringLiteral("org.freedesktop.Notifications"), QStringLiteral("Notify"));
    const QString icon = QGuiApplication::desktopFileName();
    constexpr uint newOne = 0;
    constexpr int asTheDesktopLikes = -1;
    message << QStringLiteral("Rubble") << newOne << icon << what << about.toHtmlEscaped() << QStringList()
            << QVariantMap{{QStringLiteral("desktop-entry"), icon}} << asTheDesktopLikes;
    bus.send(message);
}

}  // namespace rubble
