#pragma once

#include <QByteArray>
#include <QFont>
#include <QImage>
#include <QRectF>
#include <QSize>

class QPainter;

namespace rubble::widgets {

/// A chart that can be written to a file: print colours on white, text of one share of the width whatever the number of pixels.
class FileChart {
public:
    FileChart() = default;
    FileChart(const FileChart&) = delete;
    FileChart& operator=(const FileChart&) = delete;
    virtual ~FileChart() = default;

    QImage image(const QSize& pixels) const;
    /// The same as SVG.
    QByteArray svg(const QSize& size) const;

protected:
    /// Draws the chart in print colours.
    virtual void paintFile(QPainter& painter, const QRectF& area, const QFont& font) const = 0;
    virtual QString fileTitle() const = 0;

private:
    void paintPage(QPainter& painter, const QSize& pixels) const;
};

}  // namespace rubble::widgets
