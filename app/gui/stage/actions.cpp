#include "app/gui/stage/actions.h"

#include <QCoreApplication>
#include <QWidget>
#include <algorithm>

namespace rubble {

namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("actions", text);
}

}  // namespace

Actions::Actions(QWidget& window) {
    for (const ActionRow& row : actionTable()) {
        auto* action = new QAction(translated(row.text), &window);
        const QKeySequence key = QKeySequence::fromString(QLatin1String(row.key), QKeySequence::PortableText);
        action->setObjectName(QLatin1String(row.name));
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
        m_actions.push_back(action);
    }
}

std::vector<ActionRow> toolRows(ToolSection section) {
    std::vector<ActionRow> rows;
    for (const ActionRow& row : actionTable()) {
        if (row.place.tool && row.place.tool->section == section) {
            rows.push_back(row);
        }
    }
    std::sort(rows.begin(), rows.end(),
              [](const ActionRow& a, const ActionRow& b) { return a.place.tool->place < b.place.tool->place; });
    return rows;
}

std::optional<ActionId> actionNamed(QStringView name) {
    for (const ActionRow& row : actionTable()) {
        if (name == QLatin1String(row.name)) {
            return row.id;
        }
    }
    return std::nullopt;
}

QString actionReference() {
    QString page = QStringLiteral("# ") + QCoreApplication::translate("manual", "Actions and keys") + QStringLiteral("\n\n|") +
                   QCoreApplication::translate("manual", "Menu|Action|Key|What it does") + QStringLiteral("|\n|---|---|---|---|\n");
    for (const ActionRow& row : actionTable()) {
        page += QStringLiteral("|%1|%2|%3|%4|\n")
                    .arg(translated(row.menu), translated(row.text), QString::fromLatin1(row.key), translated(row.tip));
    }
    return page;
}

}  // namespace rubble
