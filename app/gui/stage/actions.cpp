#include "app/gui/stage/actions.h"

#include <QCoreApplication>
#include <QWidget>
#include <cassert>

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
    for (const ActionRow& row : actionTable()) {
        page += QStringLiteral("|%1|%2|%3|%4|\n")
                    .arg(translated(row.menu), translated(row.text), QString::fromLatin1(row.key), translated(row.tip));
    }
    return page;
}

}  // namespace rubble
