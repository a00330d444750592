#include "app/gui/stage/actions.h"

#include <QCoreApplication>
#include <QWidget>
#include <algorithm>
#include <array>

namespace rubble {

namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("actions", text);
}

constexpr std::array onViews{ActionId::Stacked,       ActionId::Beside,
                             ActionId::Overlay,       ActionId::Four,
                             ActionId::FeOnly,        ActionId::FragmentsOnly,
                             ActionId::OtherScenario, ActionId::Clip,
                             ActionId::MeasureHeight, ActionId::MeasureDistance,
                             ActionId::Link,          ActionId::ClearMeasurements,
                             ActionId::Fit,           ActionId::LookSide,
                             ActionId::LookFront,     ActionId::LookBack,
                             ActionId::LookLeft,      ActionId::LookRight,
                             ActionId::LookTop,       ActionId::LookBottom,
                             ActionId::LookCorner,    ActionId::Parallel,
                             ActionId::ZoomIn,        ActionId::ZoomOut,
                             ActionId::TurnLeft,      ActionId::TurnRight,
                             ActionId::TurnUp,        ActionId::TurnDown,
                             ActionId::CameraKey,     ActionId::AlongCameraKeys,
                             ActionId::Shading,       ActionId::Shadows,
                             ActionId::GroundGrid,    ActionId::Axes,
                             ActionId::MapStandard,   ActionId::MapViridis,
                             ActionId::MapCividis,    ActionId::MapGrey,
                             ActionId::ImportView};

/// Of these, what moves the camera of whatever model is seen.
constexpr std::array ofTheCamera{ActionId::Fit,        ActionId::LookSide,  ActionId::LookFront, ActionId::LookBack,
                                 ActionId::LookLeft,   ActionId::LookRight, ActionId::LookTop,   ActionId::LookBottom,
                                 ActionId::LookCorner, ActionId::Parallel,  ActionId::ZoomIn,    ActionId::ZoomOut,
                                 ActionId::TurnLeft,   ActionId::TurnRight, ActionId::TurnUp,    ActionId::TurnDown};

}  // namespace

bool actsOnViews(ActionId id) {
    return std::find(onViews.begin(), onViews.end(), id) != onViews.end();
}

QString viewsCovered() {
    return translated(QT_TRANSLATE_NOOP("actions", "It acts on the views, which a page covers now: Esc closes the page"));
}

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
        m_tips << action->toolTip();
        m_whys << QString();
    }
    m_usable.assign(m_actions.size(), true);
}

void Actions::show(ActionId id) {
    const auto place = static_cast<std::size_t>(id);
    const bool camera = std::find(ofTheCamera.begin(), ofTheCamera.end(), id) != ofTheCamera.end();
    const bool covered = !m_viewsInFront && actsOnViews(id) && !(camera && m_modelInFront);
    const QString& why = m_whys[static_cast<qsizetype>(place)];
    m_actions[place]->setEnabled(m_usable[place] && !covered);
    if (actsOnViews(id) || !why.isEmpty()) {
        const QString& tip = m_tips[static_cast<qsizetype>(place)];
        const QString reason = covered ? viewsCovered() : m_usable[place] ? QString() : why;
        m_actions[place]->setToolTip(reason.isEmpty() ? tip : tip + u'\n' + reason);
    }
}

void Actions::enable(ActionId id, bool usable, const QString& why) {
    m_usable[static_cast<std::size_t>(id)] = usable;
    if (!why.isEmpty()) {
        m_whys[static_cast<qsizetype>(id)] = why;
    }
    show(id);
}

QString Actions::refusal(const QAction& action) const {
    const auto found = std::find(m_actions.begin(), m_actions.end(), &action);
    if (found == m_actions.end() || action.isEnabled()) {
        return {};
    }
    const auto place = static_cast<std::size_t>(found - m_actions.begin());
    const QString why = m_usable[place] ? viewsCovered() : m_whys[static_cast<qsizetype>(place)];
    const QString name = action.text().remove(u'&').remove(QChar(0x2026));
    return translated(QT_TRANSLATE_NOOP("actions", "%1: %2"))
        .arg(name, why.isEmpty() ? translated(QT_TRANSLATE_NOOP("actions", "it cannot be used now")) : why);
}

void Actions::setViewsInFront(bool inFront) {
    m_viewsInFront = inFront;
    showAll();
}

void Actions::setModelInFront(bool inFront) {
    m_modelInFront = inFront;
    showAll();
}

void Actions::showAll() {
    for (const ActionId id : onViews) {
        show(id);
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
