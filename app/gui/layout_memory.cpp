#include "app/gui/layout_memory.h"

#include <QFile>
#include <QMainWindow>
#include <QSettings>
#include <QSplitter>

#include "app/gui/autosave.h"

namespace rubble {

namespace {

// Raised when docks or bars are other ones, so that an older layout is not laid over them.
constexpr int layoutVersion = 2;
const QString group = QStringLiteral("layout");

}  // namespace

LayoutMemory::LayoutMemory(QMainWindow& window, QMainWindow& docks, QSplitter& splitter)
    : m_window(window),
      m_docks(docks),
      m_splitter(splitter),
      m_firstState(window.saveState(layoutVersion)),
      m_firstDocks(docks.saveState(layoutVersion)),
      m_firstSplitter(splitter.saveState()) {}

void LayoutMemory::restore() {
    QSettings settings;
    settings.beginGroup(group);
    m_window.restoreGeometry(settings.value(QStringLiteral("window")).toByteArray());
    m_window.restoreState(settings.value(QStringLiteral("docks")).toByteArray(), layoutVersion);
    m_docks.restoreState(settings.value(QStringLiteral("inner_docks")).toByteArray(), layoutVersion);
    m_splitter.restoreState(settings.value(QStringLiteral("splitter")).toByteArray());
}

void LayoutMemory::save() const {
    QSettings settings;
    settings.beginGroup(group);
    settings.setValue(QStringLiteral("window"), m_window.saveGeometry());
    settings.setValue(QStringLiteral("docks"), m_window.saveState(layoutVersion));
    settings.setValue(QStringLiteral("inner_docks"), m_docks.saveState(layoutVersion));
    settings.setValue(QStringLiteral("splitter"), m_splitter.saveState());
}

void LayoutMemory::reset() {
    QSettings().remove(group);
    m_window.restoreState(m_firstState, layoutVersion);
    m_docks.restoreState(m_firstDocks, layoutVersion);
    m_splitter.restoreState(m_firstSplitter);
}

QString setDamagedSettingsAside() {
    const QSettings settings;
    // A section is read when something of it is asked for.
    settings.allKeys();
    if (settings.status() != QSettings::FormatError) {
        return {};
    }
    return setFileAside(settings.fileName());
}

}  // namespace rubble
