#include "widgets/basics/map_view.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "widgets/basics/theme.h"
#include "widgets/figures/sheets/map_words.h"

namespace rubble::widgets {

namespace {

constexpr double dotsPerInch = 96.0;

}  // namespace

MapView::MapView(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Map"));
    setMouseTracking(true);
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

void MapView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF pixel = event->position() * devicePixelRatioF();
    if (m_map != nullptr && !m_picture.isNull() && !m_map->cells.empty() && m_placing.cells.contains(pixel)) {
        QToolTip::showText(event->globalPosition().toPoint(), figures::placeWords(*m_map, m_layer, m_style, m_placing.at(pixel)),
                           this);
    } else {
        QToolTip::hideText();
    }
    QWidget::mouseMoveEvent(event);
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
        m_picture = figures::mapPicture(*m_map, m_layer, m_style, &m_placing);
    }
    QPainter painter(this);
    painter.drawImage(rect(), m_picture);
}

}  // namespace rubble::widgets
