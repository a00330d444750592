#pragma once

#include <QAction>
#include <QHash>
#include <optional>
#include <span>
#include <string_view>

#include "widgets/basics/icons.h"

namespace rubble {

/// One row of the table of actions: feeds menus, tool bar, keys and manual.
struct ActionRow {
    std::string_view id;
    const char* menu;  ///< "Case", "Edit", "View", "Camera", "Look", "Select", "Simulation", "Evidence", "Export", "Help"
    const char* text;
    const char* tip;
    const char* key;  ///< portable text; "" for none
    std::optional<widgets::Glyph> glyph;
    bool checkable = false;
};

std::span<const ActionRow> actionTable();

/// The actions of one window, made from the table.
class Actions {
public:
    explicit Actions(QWidget& window);
    /// The action of an id of the table.
    QAction& operator[](std::string_view id) const;

private:
    QHash<QString, QAction*> m_actions;
};

/// The actions as a table in Markdown: a page of the manual.
QString actionReference();

}  // namespace rubble
