#include <QCoreApplication>
#include <array>

#include "app/gui/window/action_table.h"

namespace rubble {

namespace {

using widgets::Glyph;

const std::array helpTable = {
    ActionRow{
        ActionId::Tour,
        "tour",
        "Help",
        QT_TRANSLATE_NOOP("actions", "Tour"),
        QT_TRANSLATE_NOOP("actions", "What this window is for, a sentence at a time: over the open case, else over the sample"),
        "",
        {}},
    ActionRow{ActionId::Manual, "manual", "Help", QT_TRANSLATE_NOOP("actions", "Manual"),
              QT_TRANSLATE_NOOP("actions", "The page of the manual about what has the focus"), "F1", Glyph::Help},
    ActionRow{ActionId::ManualSearch, "manual_search", "Help", QT_TRANSLATE_NOOP("actions", "Search the manual…"),
              QT_TRANSLATE_NOOP("actions", "Find words in the manual"), "Shift+F1", Glyph::Search},
    ActionRow{ActionId::Validation,
              "validation",
              "Help",
              QT_TRANSLATE_NOOP("actions", "Validation…"),
              QT_TRANSLATE_NOOP("actions", "How far simulated falls are from measured ones: the known rate of error"),
              "",
              {}},
    ActionRow{ActionId::About, "about", "Help", QT_TRANSLATE_NOOP("actions", "About Rubble"),
              QT_TRANSLATE_NOOP("actions", "Version and method"), "", Glyph::About},
};

}  // namespace

std::span<const ActionRow> helpActions() {
    return helpTable;
}

}  // namespace rubble
