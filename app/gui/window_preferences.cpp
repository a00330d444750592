// The part of the main window that follows the user's preferences.
#include <QAction>
#include <QMenuBar>
#include <QSettings>
#include <QTimer>
#include <limits>

#include "app/gui/accuracy_display.h"
#include "app/gui/autosave.h"
#include "app/gui/calibration_display.h"
#include "app/gui/error_display.h"
#include "app/gui/evidence_display.h"
#include "app/gui/evidence_studies.h"
#include "app/gui/forecast_display.h"
#include "app/gui/health_display.h"
#include "app/gui/inspection.h"
#include "app/gui/main_window.h"
#include "app/gui/mnemonics.h"
#include "app/gui/panel_deck.h"
#include "app/gui/playback.h"
#include "app/gui/project_display.h"
#include "app/gui/settings.h"
#include "app/gui/status_feed.h"
#include "app/gui/view_area.h"
#include "widgets/language.h"
#include "widgets/theme.h"
#include "widgets/unit_label.h"

namespace rubble {

void MainWindow::showPreferences() {
    auto* dialog = findChild<widgets::PreferencesDialog*>();
    if (dialog == nullptr) {
        dialog = new widgets::PreferencesDialog(m_preferences, this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog, &widgets::PreferencesDialog::changed, this, &MainWindow::setPreferences);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

void MainWindow::setPreferences(const widgets::Preferences& preferences) {
    QSettings settings;
    writePreferences(settings, preferences);
    if (preferences.language != m_preferences.language) {
        widgets::speak(preferences.language);
    }
    applyPreferences(preferences);
    if (auto* dialog = findChild<widgets::PreferencesDialog*>()) {
        dialog->show(preferences);
    }
}

void MainWindow::applyPreferences(const widgets::Preferences& preferences) {
    const bool otherUnits = preferences.units != figures::unitSet();
    m_preferences = preferences;
    figures::chooseColours(preferences.colours);
    figures::chooseUnits(preferences.units);
    Worker::useThreads(preferences.threads);
    m_computation.keepCopies(preferences.keepCopies);
    m_computation.useMemory(static_cast<std::size_t>(preferences.memoryMib) << 20);
    if (m_project != nullptr) {
        m_project->autosave().setInterval(preferences.autosaveSeconds);
    }
    widgets::ViewWidget::simplifyAbove(preferences.simplify ? widgets::ViewWidget::slowDraw
                                                            : std::numeric_limits<double>::infinity());
    m_actions["keep_copies"].setChecked(preferences.keepCopies);
    setTheme(preferences.theme);
    m_area->views().update();
    if (otherUnits && m_retellable) {
        widgets::tellUnitsChanged();
        retell();
        m_evidence->refresh();
    }
    m_retellable = true;
}

void MainWindow::retell() {
    giveMnemonics(*menuBar());
    m_deck->retell();
    m_accuracy->refresh();
    m_calibration->refresh();
    m_forecast->show();
    m_errors->refresh();
    m_health->refresh();
    m_studies->refresh();
    m_feed->refresh();
    if (m_project != nullptr) {
        m_project->retell();
    }
    m_inspection->refresh();
    m_document.retell();
    m_document.undoStack().indexChanged(m_document.undoStack().index());
    showTitle();
    showState();
    m_area->views().update();
}

void MainWindow::showView(render::View view) {
    view.theme = widgets::currentTheme();
    m_playback->clock().pause();
    setView(view);
    m_playback->scrub(view.time);
    m_inspection->refresh();
}

void MainWindow::showInstant(double time) {
    m_playback->clock().pause();
    m_playback->scrub(time);
}

}  // namespace rubble
