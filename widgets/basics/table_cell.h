#pragma once

#include <QString>
#include <QTableWidgetItem>

namespace rubble::widgets {

/// A cell of a table: words to the left, figures to the right. The table it is put in owns it.
inline QTableWidgetItem* tableCell(const QString& text, bool left, const QString& tip = {}) {
    auto* item = new QTableWidgetItem(text);
    item->setTextAlignment((left ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    item->setToolTip(tip);
    return item;
}

/// The same in a table of which other cells are edited: this one is not.
inline QTableWidgetItem* fixedCell(const QString& text, bool left, const QString& tip = {}) {
    QTableWidgetItem* item = tableCell(text, left, tip);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    return item;
}

}  // namespace rubble::widgets
