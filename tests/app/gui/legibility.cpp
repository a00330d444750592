#include "tests/app/gui/legibility.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTextDocument>
#include <QToolButton>

namespace rubble {

namespace {

/// px. Fonts are laid out in fractions of a pixel, widgets in whole ones.
constexpr int rounding = 2;

QString wayTo(const QWidget& widget, const QWidget& window) {
    QString way;
    for (const QWidget* at = &widget; at != nullptr && at != &window; at = at->parentWidget()) {
        const QString name = at->objectName().isEmpty() ? QLatin1String(at->metaObject()->className()) : at->objectName();
        way.prepend(u'/' + name);
    }
    return way;
}

/// The text that a widget shows itself; empty for others.
QString labelOf(const QWidget& widget) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        return label->text();
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        return button->text();
    }
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
        return box->currentText();
    }
    return {};
}

bool scrolls(const QWidget* parent) {
    return parent != nullptr && (parent->objectName() == QLatin1String("qt_scrollarea_viewport") ||
                                 qobject_cast<const QAbstractScrollArea*>(parent) != nullptr);
}

/// How much larger the text of a label is than the label.
QSize missingOf(const QLabel& label) {
    const QMargins margins = label.contentsMargins();
    const int margin = 2 * label.margin();
    const QSize room(label.width() - margins.left() - margins.right() - margin,
                     label.height() - margins.top() - margins.bottom() - margin);
    const bool rich =
        label.textFormat() == Qt::RichText || (label.textFormat() == Qt::AutoText && Qt::mightBeRichText(label.text()));
    QSize need;
    if (rich) {
        QTextDocument document;
        document.setDefaultFont(label.font());
        document.setDocumentMargin(0.0);
        document.setHtml(label.text());
        if (label.wordWrap()) {
            document.setTextWidth(room.width());
        }
        need = document.size().toSize();
    } else if (label.wordWrap()) {
        need = label.fontMetrics()
                   .boundingRect(QRect(0, 0, room.width(), 10000), static_cast<int>(label.alignment()) | Qt::TextWordWrap,
                                 label.text())
                   .size();
    } else {
        need = label.fontMetrics().size(Qt::TextShowMnemonic, label.text());
    }
    return need - room;
}

QSize missingOf(const QComboBox& box) {
    QStyleOptionComboBox option;
    option.initFrom(&box);
    const QRect field = box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box);
    return {box.fontMetrics().horizontalAdvance(box.currentText()) - field.width(), 0};
}

QSize missingOf(const QAbstractButton& button) {
    // A tool button that shows its icon alone has its text for menus.
    if (const auto* tool = qobject_cast<const QToolButton*>(&button);
        tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull()) {
        return {};
    }
    if (const QSize least = button.minimumSizeHint(); least.isValid()) {
        return least - button.size();
    }
    return button.fontMetrics().size(Qt::TextShowMnemonic, button.text()) - button.size();
}

QSize missingOf(const QWidget& widget) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        return missingOf(*label);
    }
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
        return missingOf(*box);
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        return missingOf(*button);
    }
    return {};
}

/// Head cells of a table that are narrower than their words and do not say them in a tip.
QStringList narrowHeads(const QHeaderView& header, const QString& way) {
    QStringList found;
    for (int i = 0; i < header.count() && header.orientation() == Qt::Horizontal; ++i) {
        const QString words = header.model()->headerData(i, Qt::Horizontal).toString();
        int widest = 0;
        for (const QString& line : words.split(u'\n')) {
            widest = std::max(widest, header.fontMetrics().horizontalAdvance(line));
        }
        if (!header.isSectionHidden(i) && widest > header.sectionSize(i) + rounding &&
            header.model()->headerData(i, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty()) {
            found << QStringLiteral("%1: head \"%2\" is %3 px too narrow").arg(way, words).arg(widest - header.sectionSize(i));
        }
    }
    return found;
}

}  // namespace

QStringList illegibleIn(const QWidget& window) {
    QStringList found;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible() || widget->window() != &window || widget->size().isEmpty()) {
            continue;
        }
        const QString way = wayTo(*widget, window);
        const QString text = labelOf(*widget);
        if (!text.isEmpty()) {
            const QSize missing = missingOf(*widget);
            if ((missing.width() > rounding || missing.height() > rounding) && widget->toolTip().isEmpty()) {
                found << QStringLiteral("%1: \"%2\" lacks %3 x %4 px").arg(way, text).arg(missing.width()).arg(missing.height());
            }
        }
        if (const auto* header = qobject_cast<const QHeaderView*>(widget)) {
            found << narrowHeads(*header, way);
        }
        const QWidget* parent = widget->parentWidget();
        if (parent != nullptr && !scrolls(parent) && !parent->rect().adjusted(-1, -1, 1, 1).contains(widget->geometry()) &&
            qobject_cast<const QMainWindow*>(parent) == nullptr) {
            found << QStringLiteral("%1: reaches out of its place").arg(way);
        }
        if (text.isEmpty() || parent == nullptr) {
            continue;
        }
        for (const QObject* child : parent->children()) {
            const auto* other = qobject_cast<const QWidget*>(child);
            if (other == nullptr || other <= widget || !other->isVisible() || labelOf(*other).isEmpty()) {
                continue;
            }
            const QRect common = widget->geometry().intersected(other->geometry());
            if (common.width() > rounding && common.height() > rounding) {
                found << QStringLiteral("%1: \"%2\" lies over \"%3\"").arg(way, text, labelOf(*other));
            }
        }
    }
    return found;
}

}  // namespace rubble
