#pragma once

#include <QString>

class QWidget;

namespace rubble {

/// Asks where a file is to be written. A name that ends in none of the kinds gets the ending of the one that was chosen, so that
/// no file says that it is what it is not; one that lies there under that name is replaced only if that is wanted.
/// @param kinds  as QFileDialog takes them: "GeoTIFF (*.tif);;Tables (*.csv)"
/// @returns empty: nowhere
QString askSavePath(QWidget* parent, const QString& title, const QString& proposed, const QString& kinds);

}  // namespace rubble
