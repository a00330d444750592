#pragma once

#include <QImage>
#include <QWidget>
#include <memory>

#include "widgets/figures/map_picture.h"

namespace rubble::widgets {

/// A layer of a map at the size of the widget, in the colours of the window. Beside the pointer stand the place and its value.
class MapView : public QWidget {
    Q_OBJECT

public:
    explicit MapView(QWidget* parent = nullptr);

    /// Null: nothing is shown.
    /// @param style  its size, its dots per inch and its theme are those of the widget
    void setMap(std::shared_ptr<const DebrisMap> map, MapLayer layer, const figures::MapPictureStyle& style);
    QSize sizeHint() const override { return {480, 360}; }
    QSize minimumSizeHint() const override { return {240, 220}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    std::shared_ptr<const DebrisMap> m_map;
    MapLayer m_layer = MapLayer::Probability;
    figures::MapPictureStyle m_style;
    QImage m_picture;  // as last drawn; null: draw it anew
    figures::MapPlacing m_placing;
};

}  // namespace rubble::widgets
