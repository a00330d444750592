#pragma once

#include <QLabel>

#include "widgets/basics/theme.h"

namespace rubble::widgets {

/// The line above the rows of one group.
inline QLabel* groupHeading(const QString& words) {
    auto* label = new QLabel(words);
    label->setObjectName(QStringLiteral("groupHeading"));
    label->setFont(headingFont());
    return label;
}

}  // namespace rubble::widgets
