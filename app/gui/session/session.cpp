#include "app/gui/session/session.h"

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

void Session::usePreferences() {
    Worker::useThreads(m_preferences.threads);
    m_computation.keepCopies(m_preferences.keepCopies);
    m_computation.useMemory(static_cast<std::size_t>(m_preferences.memoryMib) << 20);
}

}  // namespace rubble
