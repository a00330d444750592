#include "app/gui/actions.h"

#include <QCoreApplication>
#include <QWidget>
#include <array>
#include <cassert>

namespace rubble {

namespace {

using widgets::Glyph;

const std::array table = {
    ActionRow{"open", "Case", QT_TRANSLATE_NOOP("actions", "Open…"), QT_TRANSLATE_NOOP("actions", "Open a case or an FE result"),
              "Ctrl+O", Glyph::Open},
    ActionRow{"sample",
              "Case",
              QT_TRANSLATE_NOOP("actions", "Open the sample"),
              QT_TRANSLATE_NOOP("actions", "Open the collapse of the stone arch bridge and simulate it"),
              "",
              {}},
    ActionRow{"refresh",
              "Case",
              QT_TRANSLATE_NOOP("actions", "Refresh result"),
              QT_TRANSLATE_NOOP("actions", "Look what the analysis has written since, and show it; settings, time and camera stay"),
              "F5",
              {}},
    ActionRow{"keep_copies",
              "Case",
              QT_TRANSLATE_NOOP("actions", "Keep copies of results"),
              QT_TRANSLATE_NOOP("actions", "Keep a compressed copy of every FE result that is read: it opens at once next time"),
              "",
              {},
              true},
    ActionRow{"duplicate_scenario",
              "Case",
              QT_TRANSLATE_NOOP("actions", "Duplicate scenario"),
              QT_TRANSLATE_NOOP("actions", "Go on with a copy of the scenario; the Case panel lists all of them"),
              "Ctrl+D",
              {}},
    ActionRow{"compare_scenarios",
              "Case",
              QT_TRANSLATE_NOOP("actions", "Compare scenarios…"),
              QT_TRANSLATE_NOOP("actions", "Show in which settings and results two scenarios differ"),
              "",
              {}},
    ActionRow{"terrain",
              "Case",
              QT_TRANSLATE_NOOP("actions", "Terrain…"),
              QT_TRANSLATE_NOOP("actions", "Choose the raster of heights that the debris falls on"),
              "",
              {}},
    ActionRow{"no_terrain",
              "Case",
              QT_TRANSLATE_NOOP("actions", "Without terrain"),
              QT_TRANSLATE_NOOP("actions", "Let the debris fall on level ground again"),
              "",
              {}},
    ActionRow{"save", "Case", QT_TRANSLATE_NOOP("actions", "Save case"), QT_TRANSLATE_NOOP("actions", "Save the case"), "Ctrl+S",
              Glyph::Save},
    ActionRow{"save_as",
              "Case",
              QT_TRANSLATE_NOOP("actions", "Save case as…"),
              QT_TRANSLATE_NOOP("actions", "Save the case under another name"),
              "Ctrl+Shift+S",
              {}},
    ActionRow{"save_run",
              "Case",
              QT_TRANSLATE_NOOP("actions", "Save run as…"),
              QT_TRANSLATE_NOOP("actions", "Save the last run as a run file, for rubble-cli and for later"),
              "",
              {}},
    ActionRow{
        "close", "Case", QT_TRANSLATE_NOOP("actions", "Close case"), QT_TRANSLATE_NOOP("actions", "Close the case"), "Ctrl+W", {}},
    ActionRow{"quit", "Case", QT_TRANSLATE_NOOP("actions", "Quit"), QT_TRANSLATE_NOOP("actions", "Leave Rubble"), "Ctrl+Q", {}},
    ActionRow{"undo", "Edit", QT_TRANSLATE_NOOP("actions", "Undo"), QT_TRANSLATE_NOOP("actions", "Take the last change back"),
              "Ctrl+Z", Glyph::Undo},
    ActionRow{"redo", "Edit", QT_TRANSLATE_NOOP("actions", "Redo"), QT_TRANSLATE_NOOP("actions", "Make the change again"),
              "Ctrl+Shift+Z", Glyph::Redo},
    ActionRow{"preset_default",
              "Edit",
              QT_TRANSLATE_NOOP("actions", "Settings as delivered"),
              QT_TRANSLATE_NOOP("actions", "Apply the default settings"),
              "",
              {}},
    ActionRow{"preset_paper",
              "Edit",
              QT_TRANSLATE_NOOP("actions", "Settings as published"),
              QT_TRANSLATE_NOOP("actions", "Apply the settings of the published method"),
              "",
              {}},
    ActionRow{"preferences",
              "Edit",
              QT_TRANSLATE_NOOP("actions", "Preferences…"),
              QT_TRANSLATE_NOOP("actions", "Language, colours, threads, memory, autosave"),
              "Ctrl+,",
              {}},
    ActionRow{"stacked", "View", QT_TRANSLATE_NOOP("actions", "Stacked"),
              QT_TRANSLATE_NOOP("actions", "FE view above the fragments"), "1", Glyph::Stacked, true},
    ActionRow{"beside", "View", QT_TRANSLATE_NOOP("actions", "Beside"),
              QT_TRANSLATE_NOOP("actions", "FE view left, fragments right"), "2", Glyph::Beside, true},
    ActionRow{"fe_only", "View", QT_TRANSLATE_NOOP("actions", "FE only"),
              QT_TRANSLATE_NOOP("actions", "Only the conventional FE view"), "3", Glyph::FeOnly, true},
    ActionRow{"fragments_only", "View", QT_TRANSLATE_NOOP("actions", "Fragments only"),
              QT_TRANSLATE_NOOP("actions", "Only the view with the fragments"), "4", Glyph::FragmentsOnly, true},
    ActionRow{"link", "View", QT_TRANSLATE_NOOP("actions", "Cameras linked"),
              QT_TRANSLATE_NOOP("actions", "Both views look from the same place"), "L", Glyph::Link, true},
    ActionRow{"fit", "View", QT_TRANSLATE_NOOP("actions", "Fit"), QT_TRANSLATE_NOOP("actions", "Show the whole model"), "F",
              Glyph::Fit},
    ActionRow{"look_side",
              "View",
              QT_TRANSLATE_NOOP("actions", "From the side"),
              QT_TRANSLATE_NOOP("actions", "Look from the side, slightly from above"),
              "Shift+S",
              {}},
    ActionRow{"look_front",
              "View",
              QT_TRANSLATE_NOOP("actions", "Along y"),
              QT_TRANSLATE_NOOP("actions", "Look straight along y"),
              "Shift+F",
              {}},
    ActionRow{"look_top",
              "View",
              QT_TRANSLATE_NOOP("actions", "From above"),
              QT_TRANSLATE_NOOP("actions", "Look straight down"),
              "Shift+T",
              {}},
    ActionRow{"history",
              "View",
              QT_TRANSLATE_NOOP("actions", "History"),
              QT_TRANSLATE_NOOP("actions", "List every edit since the case was opened; a click goes there"),
              "Ctrl+H",
              {},
              true},
    ActionRow{"reset_layout",
              "View",
              QT_TRANSLATE_NOOP("actions", "Reset layout"),
              QT_TRANSLATE_NOOP("actions", "Put panels, docks and bars back where they were at the first start"),
              "",
              {}},
    ActionRow{"theme_system",
              "View",
              QT_TRANSLATE_NOOP("actions", "Colours of the system"),
              QT_TRANSLATE_NOOP("actions", "Light or dark as the system has it"),
              "",
              {},
              true},
    ActionRow{
        "theme_light", "View", QT_TRANSLATE_NOOP("actions", "Light"), QT_TRANSLATE_NOOP("actions", "Light colours"), "", {}, true},
    ActionRow{
        "theme_dark", "View", QT_TRANSLATE_NOOP("actions", "Dark"), QT_TRANSLATE_NOOP("actions", "Dark colours"), "", {}, true},
    ActionRow{"simulate",
              "Simulation",
              QT_TRANSLATE_NOOP("actions", "Simulate"),
              QT_TRANSLATE_NOOP("actions", "Simulate the whole collapse as fast as it goes"),
              "Ctrl+R",
              {}},
    ActionRow{"live", "Simulation", QT_TRANSLATE_NOOP("actions", "Live"),
              QT_TRANSLATE_NOOP("actions", "Simulate at the pace of the collapse and watch"), "Ctrl+L", Glyph::Live},
    ActionRow{"cancel", "Simulation", QT_TRANSLATE_NOOP("actions", "Cancel"),
              QT_TRANSLATE_NOOP("actions", "Stop what runs; what is computed is kept"), "Esc", Glyph::Stop},
    ActionRow{"play", "Simulation", QT_TRANSLATE_NOOP("actions", "Play or pause"), QT_TRANSLATE_NOOP("actions", "Play or pause"),
              "Space", Glyph::Play},
    ActionRow{"back", "Simulation", QT_TRANSLATE_NOOP("actions", "Back one state"), QT_TRANSLATE_NOOP("actions", "Back one state"),
              "Left", Glyph::Back},
    ActionRow{"forward", "Simulation", QT_TRANSLATE_NOOP("actions", "Forward one state"),
              QT_TRANSLATE_NOOP("actions", "Forward one state"), "Right", Glyph::Forward},
    ActionRow{"back_ten",
              "Simulation",
              QT_TRANSLATE_NOOP("actions", "Back ten states"),
              QT_TRANSLATE_NOOP("actions", "Back ten states"),
              "Shift+Left",
              {}},
    ActionRow{"forward_ten",
              "Simulation",
              QT_TRANSLATE_NOOP("actions", "Forward ten states"),
              QT_TRANSLATE_NOOP("actions", "Forward ten states"),
              "Shift+Right",
              {}},
    ActionRow{"first", "Simulation", QT_TRANSLATE_NOOP("actions", "To the first instant"),
              QT_TRANSLATE_NOOP("actions", "To the first instant"), "Home", Glyph::First},
    ActionRow{"last", "Simulation", QT_TRANSLATE_NOOP("actions", "To the last instant"),
              QT_TRANSLATE_NOOP("actions", "To the last instant"), "End", Glyph::Last},
    ActionRow{"play_backwards", "Simulation", QT_TRANSLATE_NOOP("actions", "Play backwards"),
              QT_TRANSLATE_NOOP("actions", "Play backwards or pause"), "Shift+Space", Glyph::PlayBack},
    ActionRow{"loop", "Simulation", QT_TRANSLATE_NOOP("actions", "Loop"),
              QT_TRANSLATE_NOOP("actions", "Playback goes round the range dragged with Shift in the timeline, or round all of it"),
              "Ctrl+Shift+L", Glyph::Loop, true},
    ActionRow{"loop_from",
              "Simulation",
              QT_TRANSLATE_NOOP("actions", "Loop from here"),
              QT_TRANSLATE_NOOP("actions", "The range that playback goes round begins at this instant"),
              "[",
              {}},
    ActionRow{"loop_to",
              "Simulation",
              QT_TRANSLATE_NOOP("actions", "Loop to here"),
              QT_TRANSLATE_NOOP("actions", "The range that playback goes round ends at this instant"),
              "]",
              {}},
    ActionRow{"bookmark", "Simulation", QT_TRANSLATE_NOOP("actions", "Bookmark…"),
              QT_TRANSLATE_NOOP("actions", "Mark this instant with a note; kept in the case"), "B", Glyph::Bookmark},
    ActionRow{"previous_bookmark",
              "Simulation",
              QT_TRANSLATE_NOOP("actions", "To the bookmark before"),
              QT_TRANSLATE_NOOP("actions", "To the bookmark before"),
              ",",
              {}},
    ActionRow{"next_bookmark",
              "Simulation",
              QT_TRANSLATE_NOOP("actions", "To the next bookmark"),
              QT_TRANSLATE_NOOP("actions", "To the next bookmark"),
              ".",
              {}},
    ActionRow{
        "snap",
        "Simulation",
        QT_TRANSLATE_NOOP("actions", "Snap to states"),
        QT_TRANSLATE_NOOP("actions", "Scrubbing stops at true states and recorded frames only, so that nothing is interpolated"),
        "",
        {},
        true},
    ActionRow{"time_from_zero",
              "Simulation",
              QT_TRANSLATE_NOOP("actions", "Time from zero"),
              QT_TRANSLATE_NOOP("actions", "Count times from the first state instead of as the FE result has them"),
              "",
              {},
              true},
    ActionRow{"export_figure",
              "Export",
              QT_TRANSLATE_NOOP("actions", "Figure of this instant…"),
              QT_TRANSLATE_NOOP("actions", "Save both views as a figure for print"),
              "Ctrl+E",
              {}},
    ActionRow{"export_fragments",
              "Export",
              QT_TRANSLATE_NOOP("actions", "Table of fragments…"),
              QT_TRANSLATE_NOOP("actions", "Save where every fragment went, as CSV"),
              "",
              {}},
    ActionRow{"export_series",
              "Export",
              QT_TRANSLATE_NOOP("actions", "Series for ParaView…"),
              QT_TRANSLATE_NOOP("actions", "Save fragments and active structure over time, as PVD"),
              "",
              {}},
    ActionRow{"tour",
              "Help",
              QT_TRANSLATE_NOOP("actions", "Tour"),
              QT_TRANSLATE_NOOP("actions", "What the parts of this window are for, in five steps"),
              "",
              {}},
    ActionRow{"manual", "Help", QT_TRANSLATE_NOOP("actions", "Manual"),
              QT_TRANSLATE_NOOP("actions", "The page of the manual about what has the focus"), "F1", Glyph::Help},
    ActionRow{"manual_search",
              "Help",
              QT_TRANSLATE_NOOP("actions", "Search the manual…"),
              QT_TRANSLATE_NOOP("actions", "Find words in the manual"),
              "Shift+F1",
              {}},
    ActionRow{
        "about", "Help", QT_TRANSLATE_NOOP("actions", "About Rubble"), QT_TRANSLATE_NOOP("actions", "Version and method"), "", {}},
};

/// The titles of the menus.
[[maybe_unused]] constexpr std::array titles = {QT_TRANSLATE_NOOP("actions", "Case"),   QT_TRANSLATE_NOOP("actions", "Edit"),
                                                QT_TRANSLATE_NOOP("actions", "View"),   QT_TRANSLATE_NOOP("actions", "Simulation"),
                                                QT_TRANSLATE_NOOP("actions", "Export"), QT_TRANSLATE_NOOP("actions", "Help")};

QString translated(const char* text) {
    return QCoreApplication::translate("actions", text);
}

}  // namespace

std::span<const ActionRow> actionTable() {
    return table;
}

Actions::Actions(QWidget& window) {
    for (const ActionRow& row : table) {
        auto* action = new QAction(translated(row.text), &window);
        const QKeySequence key = QKeySequence::fromString(QLatin1String(row.key), QKeySequence::PortableText);
        action->setObjectName(QString::fromUtf8(row.id.data(), static_cast<qsizetype>(row.id.size())));
        action->setShortcut(key);
        action->setProperty("source", QString::fromUtf8(row.text));
        action->setToolTip(key.isEmpty()
                               ? translated(row.tip)
                               : QStringLiteral("%1 (%2)").arg(translated(row.tip), key.toString(QKeySequence::NativeText)));
        action->setCheckable(row.checkable);
        if (row.glyph) {
            action->setIcon(widgets::glyphIcon(*row.glyph));
        }
        window.addAction(action);
        m_actions.insert(action->objectName(), action);
    }
}

QAction& Actions::operator[](std::string_view id) const {
    QAction* action = m_actions.value(QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size())));
    assert(action != nullptr);
    return *action;
}

QString actionReference() {
    QString page = QStringLiteral("# ") + QCoreApplication::translate("manual", "Actions and keys") + QStringLiteral("\n\n|") +
                   QCoreApplication::translate("manual", "Menu|Action|Key|What it does") + QStringLiteral("|\n|---|---|---|---|\n");
    for (const ActionRow& row : table) {
        page += QStringLiteral("|%1|%2|%3|%4|\n")
                    .arg(translated(row.menu), translated(row.text), QString::fromLatin1(row.key), translated(row.tip));
    }
    return page;
}

}  // namespace rubble
