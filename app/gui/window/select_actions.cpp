#include <QCoreApplication>
#include <array>

#include "app/gui/window/action_table.h"

namespace rubble {

namespace {

const std::array selectTable = {
    ActionRow{ActionId::SelectBy,
              "select_by",
              "Select",
              QT_TRANSLATE_NOOP("actions", "Select by…"),
              QT_TRANSLATE_NOOP("actions", "Select by component, birth time, cluster or region"),
              "Ctrl+F",
              {},
              true},
    ActionRow{
        ActionId::FragmentTable,
        "fragment_table",
        "Select",
        QT_TRANSLATE_NOOP("actions", "Fragment table"),
        QT_TRANSLATE_NOOP("actions", "All fragments in a table; show only those of some speed, mass, size, birth or component"),
        "Ctrl+T",
        {},
        true},
    ActionRow{ActionId::SelectCluster,
              "select_cluster",
              "Select",
              QT_TRANSLATE_NOOP("actions", "Whole clusters"),
              QT_TRANSLATE_NOOP("actions", "Select all fragments that move with those selected"),
              "K",
              {}},
    ActionRow{ActionId::SelectComponent,
              "select_component",
              "Select",
              QT_TRANSLATE_NOOP("actions", "Whole components"),
              QT_TRANSLATE_NOOP("actions", "Select all elements of the components of those selected"),
              "Shift+K",
              {}},
    ActionRow{ActionId::SelectNone,
              "select_none",
              "Select",
              QT_TRANSLATE_NOOP("actions", "Nothing"),
              QT_TRANSLATE_NOOP("actions", "Select nothing"),
              "Ctrl+Shift+A",
              {}},
    ActionRow{ActionId::Hide,
              "hide",
              "Select",
              QT_TRANSLATE_NOOP("actions", "Hide"),
              QT_TRANSLATE_NOOP("actions", "Leave what is selected out of the views; what it covered appears"),
              "H",
              {},
              false,
              {.line = true}},
    ActionRow{ActionId::Isolate,
              "isolate",
              "Select",
              QT_TRANSLATE_NOOP("actions", "Isolate"),
              QT_TRANSLATE_NOOP("actions", "Hide everything that is not selected"),
              "Shift+I",
              {}},
    ActionRow{ActionId::ShowAll,
              "show_all",
              "Select",
              QT_TRANSLATE_NOOP("actions", "Show all"),
              QT_TRANSLATE_NOOP("actions", "Show every component and element again"),
              "Shift+H",
              {}},
    ActionRow{ActionId::GoToBirth,
              "go_to_birth",
              "Select",
              QT_TRANSLATE_NOOP("actions", "Go to its birth"),
              QT_TRANSLATE_NOOP("actions", "Show the last state at which the selected element is active, with it in the middle"),
              "G",
              {}},
};

}  // namespace

std::span<const ActionRow> selectActions() {
    return selectTable;
}

}  // namespace rubble
