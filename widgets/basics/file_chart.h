#pragma once

#include <QByteArray>
#include <QFont>
#include <QImage>
#include <QRectF>
#include <QSize>
#include <QString>

class QPainter;

namespace rubble::widgets {

/// What stands around a chart in a file.
struct ChartNote {
    QString subject;   ///< of what the chart is, beside its title; empty: its title alone
    QString cautions;  ///< what must be known beside it; empty: nothing
    QString foot;      ///< what it was made from, and by what
};

/// A chart that can be written to a file: print colours on white, text of one share of the width whatever the number of pixels.
class FileChart {
public:
    FileChart() = default;
    FileChart(const FileChart&) = delete;
    FileChart& operator=(const FileChart&) = delete;
    virtual ~FileChart() = default;

    QImage image(const QSize& pixels, const ChartNote& note = {}) const;
    /// The same as SVG.
    QByteArray svg(const QSize& size, const ChartNote& note = {}) const;
    virtual QString fileTitle() const = 0;

protected:
    /// Draws the chart in print colours.
    virtual void paintFile(QPainter& painter, const QRectF& area, const QFont& font) const = 0;

private:
    void paintPage(QPainter& painter, const QSize& pixels, const ChartNote& note) const;
};

}  // namespace rubble::widgets
