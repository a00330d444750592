#include "widgets/basics/map_view.h"

#include <QEvent>
#include <QPainter>

#include "widgets/basics/theme.h"

namespace rubble::widgets {

namespace {

constexpr double dotsPerInch = 96.0;

}  // namespace

MapView::MapView(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Map"));
}

void MapView::setMap(std::shared_ptr<const DebrisMap> map, MapLayer layer, const figures::MapPictureStyle& style) {
    m_map = std::move(map);
    m_layer = layer;
    m_style = style;
    m_picture = {};
    update();
}

void MapView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::LanguageChange || event->type() == QEvent::StyleChange) {
        m_picture = {};
        update();
    }
    QWidget::changeEvent(event);
}

void MapView::paintEvent(QPaintEvent*) {
    if (m_map == nullptr || !m_map->has(m_layer)) {
        return;
    }
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo(QSize(100, 100));
    if (m_picture.size() != pixels || m_style.theme != currentTheme()) {
        m_style.pixels = pixels;
        m_style.dpi = dotsPerInch * devicePixelRatioF();
        m_style.theme = currentTheme();
        m_style.shownUnits = true;
        m_picture = figures::mapPicture(*m_map, m_layer, m_style);
    }
    QPainter painter(this);
    painter.drawImage(rect(), m_picture);
}

}  // namespace rubble::widgets
