#include "app/gui/case/layout_memory.h"

#include <QFile>
#include <QMainWindow>
#include <QSettings>
#include <QSplitter>

#include "app/gui/case/autosave.h"

namespace rubble {

namespace {

// Raised when docks or bars are other ones, so that an older layout is not laid over them.
constexpr int layoutVersion = 3;
const QString layoutGroup = QStringLiteral("layout");

}  // namespace

LayoutMemory::LayoutMemory(QMainWindow& window, QMainWindow& docks, QSplitter& splitter)
    : m_window(window),
      m_docks(docks),
      m_splitter(splitter),
      m_firstState(window.saveState(layoutVersion)),
      m_firstDocks(docks.saveState(layoutVersion)),
      m_firstSplitter(splitter.saveState()) {}

LayoutMemory::Layout LayoutMemory::now() const {
    return {m_window.saveGeometry(), m_window.saveState(layoutVersion), m_docks.saveState(layoutVersion), m_splitter.saveState()};
}

void LayoutMemory::show(const Layout& layout) {
    m_window.restoreGeometry(layout.window);
    m_window.restoreState(layout.bars, layoutVersion);
    m_docks.restoreState(layout.docks, layoutVersion);
    m_splitter.restoreState(layout.splitter);
}

void LayoutMemory::restore() {
    QSettings settings;
    settings.beginGroup(layoutGroup);
    const auto kept = [&](const char* key) { return settings.value(QLatin1String(key)).toByteArray(); };
    show({kept("window"), kept("docks"), kept("inner_docks"), kept("splitter")});
}

void LayoutMemory::save() const {
    const Layout layout = now();
    QSettings settings;
    settings.beginGroup(layoutGroup);
    settings.setValue(QStringLiteral("window"), layout.window);
    settings.setValue(QStringLiteral("docks"), layout.bars);
    settings.setValue(QStringLiteral("inner_docks"), layout.docks);
    settings.setValue(QStringLiteral("splitter"), layout.splitter);
}

void LayoutMemory::reset() {
    QSettings().remove(layoutGroup);
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
