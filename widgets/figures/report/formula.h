#pragma once

#include <QByteArray>
#include <QPainterPath>
#include <QSizeF>
#include <QString>

namespace rubble::figures {

/// A formula set for print, as outlines: the same in PDF and HTML, whatever fonts a reader has.
struct SetFormula {
    QPainterPath outline;  ///< baseline at y = 0, from x = 0
    double width = 0.0;
    double ascent = 0.0;
    double descent = 0.0;

    QSizeF size() const { return {width, ascent + descent}; }
};

/// Sets a formula in the notation of TeX, as far as the report needs it: letters (italic), figures and signs (upright), _{} ^{},
/// \frac{}{}, \sqrt[]{}, \sum, \int, \text{}, \mathbf{}, Greek letters and signs by name. Unknown names are set as they are.
/// @param size  of the letters, in the unit that comes back
SetFormula setFormula(const QString& notation, double size);

/// The formula as an SVG drawing of its own. @param words  for readers who cannot see it
QByteArray formulaSvg(const QString& notation, double size, const QString& words);

}  // namespace rubble::figures
