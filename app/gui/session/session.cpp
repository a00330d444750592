#include "app/gui/session/session.h"

#include <QFileInfo>
#include <QSettings>

#include "app/gui/session/settings.h"

namespace rubble {

Session::Session(QObject* parent) : QObject(parent) {
    QSettings settings;
    m_preferences = readPreferences(settings, &m_complaints);
    usePreferences();
}

Session::~Session() {
    m_computation.disconnect();
    m_computation.cancel();
    while (!m_parts.empty()) {
        m_parts.pop_back();
    }
}

void Session::setPreferences(const widgets::Preferences& preferences) {
    QSettings settings;
    writePreferences(settings, preferences);
    const widgets::Preferences before = std::exchange(m_preferences, preferences);
    usePreferences();
    emit preferencesChanged(before);
}

void Session::tellWritten(const QString& path, const std::exception_ptr& thrown) {
    if (const auto failure = failureOf(thrown)) {
        report(*failure);
    } else if (thrown == nullptr) {
        tell(tr("Saved %1").arg(QFileInfo(path).fileName()));
    } else {
        tell(tr("Cancelled; nothing half-made is left"));
    }
}

bool Session::writeNow(const QString& path, const std::function<void()>& write) {
    std::exception_ptr thrown;
    try {
        write();
    } catch (...) {
        thrown = std::current_exception();
    }
    tellWritten(path, thrown);
    return thrown == nullptr;
}

void Session::usePreferences() {
    Worker::useThreads(m_preferences.threads);
    m_computation.keepCopies(m_preferences.keepCopies);
    m_computation.useMemory(static_cast<std::size_t>(m_preferences.memoryMib) << 20);
}

}  // namespace rubble
