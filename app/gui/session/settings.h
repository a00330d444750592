#pragma once

#include <QSettings>
#include <QStringList>

#include "widgets/case/preferences_dialog.h"

namespace rubble {

/// Reads the preferences of this user. What is damaged or out of range is as delivered, and is named among the complaints.
widgets::Preferences readPreferences(QSettings& settings, QStringList* complaints = nullptr);
void writePreferences(QSettings& settings, const widgets::Preferences& preferences);

}  // namespace rubble
