#include "app/gui/window/action_table.h"

#include <QCoreApplication>
#include <array>
#include <vector>

namespace rubble {

namespace {

/// The titles of the menus.
[[maybe_unused]] constexpr std::array titles = {
    QT_TRANSLATE_NOOP("actions", "Case"),       QT_TRANSLATE_NOOP("actions", "Edit"),     QT_TRANSLATE_NOOP("actions", "View"),
    QT_TRANSLATE_NOOP("actions", "Camera"),     QT_TRANSLATE_NOOP("actions", "Look"),     QT_TRANSLATE_NOOP("actions", "Select"),
    QT_TRANSLATE_NOOP("actions", "Simulation"), QT_TRANSLATE_NOOP("actions", "Evidence"), QT_TRANSLATE_NOOP("actions", "Export"),
    QT_TRANSLATE_NOOP("actions", "Help")};

std::vector<ActionRow> joined() {
    std::vector<ActionRow> rows;
    for (const auto part :
         {caseActions(), viewActions(), selectActions(), simulationActions(), evidenceActions(), exportActions(), helpActions()}) {
        rows.insert(rows.end(), part.begin(), part.end());
    }
    return rows;
}

}  // namespace

std::span<const ActionRow> actionTable() {
    static const std::vector<ActionRow> table = joined();
    return table;
}

}  // namespace rubble
