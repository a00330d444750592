#include "widgets/evidence/photo_view.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/basics/drawing_keys.h"
#include "widgets/basics/theme.h"
#include "widgets/evidence/point_marks.h"

namespace rubble::widgets {

namespace {

constexpr double zoomMost = 64.0;
constexpr double near = 9.0;     // px of the screen
constexpr int blinkEvery = 600;  // ms

QPolygonF polygonOf(const PhotoView& view, const std::vector<Eigen::Vector2d>& corners) {
    QPolygonF polygon;
    for (const Eigen::Vector2d& corner : corners) {
        polygon << view.toWidget({corner.x(), corner.y()});
    }
    return polygon;
}

QPen maskPen(MaskClass kind, bool chosen) {
    QPen pen(maskColour(kind), chosen ? 3.0 : 2.0);
    switch (kind) {
        case MaskClass::Debris:
            break;
        case MaskClass::Moved:
            pen.setStyle(Qt::DashLine);
            break;
        case MaskClass::Hidden:
            pen.setStyle(Qt::DotLine);
            break;
        case MaskClass::NotDebris:
            pen.setStyle(Qt::DashDotLine);
            break;
    }
    return pen;
}

}  // namespace

QString maskWords(MaskClass kind) {
    switch (kind) {
        case MaskClass::Debris:
            return PhotoView::tr("debris outline");
        case MaskClass::Moved:
            return PhotoView::tr("moved by rescuers");
        case MaskClass::Hidden:
            return PhotoView::tr("hidden");
        case MaskClass::NotDebris:
            break;
    }
    return PhotoView::tr("not debris");
}

QColor maskColour(MaskClass kind) {
    // Okabe & Ito: told apart by the colour-blind; vermilion stays with the simulated fragments.
    switch (kind) {
        case MaskClass::Debris:
            return {0x00, 0x9e, 0x73};
        case MaskClass::Moved:
            return {0xf0, 0xe4, 0x42};
        case MaskClass::Hidden:
            return {0x56, 0xb4, 0xe9};
        case MaskClass::NotDebris:
            break;
    }
    return {0xcc, 0x79, 0xa7};
}

PhotoView::PhotoView(QWidget* parent) : QWidget(parent) {
    setMinimumSize(240, 160);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(tr("Photograph"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    m_blink.setInterval(blinkEvery);
    connect(&m_blink, &QTimer::timeout, this, [this] {
        m_blinkOn = !m_blinkOn;
        update();
    });
}

void PhotoView::setContent(const Content& content) {
    const bool other = content.size != m_content.size || content.title != m_content.title;
    m_content = content;
    if (other) {
        m_corners.clear();
        m_cross = QPointF(content.size.width() / 2.0, content.size.height() / 2.0);
        fit();
    }
    update();
}

void PhotoView::setOverlay(const QImage& overlay, const QString& caption) {
    m_overlay = overlay;
    m_overlayCaption = caption;
    update();
}

void PhotoView::setShow(Show show) {
    m_show = show;
    m_blinkOn = true;
    show == Show::Blink ? m_blink.start() : m_blink.stop();
    update();
}

void PhotoView::setTool(Tool tool, MaskClass kind) {
    m_tool = tool;
    m_kind = kind;
    m_corners.clear();
    m_crossShown = false;
    m_hovered = false;
    setCursor(tool == Tool::Look ? Qt::ArrowCursor : Qt::CrossCursor);
    update();
}

void PhotoView::setBlend(double share) {
    m_blend = std::clamp(share, 0.0, 1.0);
    update();
}

void PhotoView::setSwipe(double share) {
    m_swipe = std::clamp(share, 0.0, 1.0);
    update();
}

double PhotoView::scale() const {
    if (m_content.size.isEmpty()) {
        return 1.0;
    }
    const double whole =
        std::min(static_cast<double>(width()) / m_content.size.width(), static_cast<double>(height()) / m_content.size.height());
    return whole * m_zoom;
}

QRectF PhotoView::frame() const {
    const QSizeF shown = QSizeF(m_content.size) * scale();
    return {QPointF(width() / 2.0 - m_middle.x() * shown.width(), height() / 2.0 - m_middle.y() * shown.height()), shown};
}

QPointF PhotoView::toWidget(const QPointF& pixel) const {
    return frame().topLeft() + pixel * scale();
}

QPointF PhotoView::toPhotograph(const QPointF& place) const {
    return (place - frame().topLeft()) / scale();
}

void PhotoView::fit() {
    m_zoom = 1.0;
    m_middle = {0.5, 0.5};
    update();
}

void PhotoView::lookAt(const QPointF& pixel) {
    if (!m_content.size.isEmpty()) {
        m_zoom = std::max(m_zoom, 4.0);
        m_middle = {pixel.x() / m_content.size.width(), pixel.y() / m_content.size.height()};
        update();
    }
}

void PhotoView::zoomAt(const QPointF& place, double factor) {
    const QPointF pixel = toPhotograph(place);
    m_zoom = std::clamp(m_zoom * factor, 1.0, zoomMost);
    const QPointF off = (toWidget(pixel) - place) / scale();
    m_middle += QPointF(off.x() / std::max(1, m_content.size.width()), off.y() / std::max(1, m_content.size.height()));
    m_middle = {std::clamp(m_middle.x(), 0.0, 1.0), std::clamp(m_middle.y(), 0.0, 1.0)};
    if (m_zoom == 1.0) {
        m_middle = {0.5, 0.5};
    }
    update();
}

void PhotoView::resizeEvent(QResizeEvent*) {
    update();
}

void PhotoView::wheelEvent(QWheelEvent* event) {
    zoomAt(event->position(), std::pow(1.2, event->angleDelta().y() / 120.0));
    event->accept();
}

int PhotoView::markAt(const QPointF& place) const {
    int found = -1;
    double least = near;
    for (std::size_t i = 0; i < m_content.marks.size(); ++i) {
        const QPointF off = toWidget(m_content.marks[i].at) - place;
        const double distance = std::hypot(off.x(), off.y());
        if (distance < least) {
            least = distance;
            found = static_cast<int>(i);
        }
    }
    return found;
}

int PhotoView::maskAt(const QPointF& place) const {
    for (std::size_t i = m_content.masks.size(); i-- > 0;) {
        if (polygonOf(*this, m_content.masks[i].corners).containsPoint(place, Qt::OddEvenFill)) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

void PhotoView::use(const QPointF& pixel) {
    const QPointF inside(std::clamp(pixel.x(), 0.0, static_cast<double>(m_content.size.width())),
                         std::clamp(pixel.y(), 0.0, static_cast<double>(m_content.size.height())));
    if (m_tool == Tool::Point) {
        emit pointPlaced(inside);
    } else if (m_tool == Tool::Mask) {
        const bool closes = m_corners.size() >= 3 && [&] {
            const QPointF off = toWidget({m_corners.front().x(), m_corners.front().y()}) - toWidget(inside);
            return std::hypot(off.x(), off.y()) < near;
        }();
        if (closes) {
            finishMask();
        } else {
            m_corners.emplace_back(inside.x(), inside.y());
        }
    }
    update();
}

void PhotoView::finishMask() {
    // A double click has set its corner twice.
    while (m_corners.size() >= 2 && (m_corners.back() - m_corners[m_corners.size() - 2]).norm() * scale() < 2.0) {
        m_corners.pop_back();
    }
    if (m_corners.size() >= 3) {
        const PhotoMask mask{m_kind, m_corners};
        m_corners.clear();
        emit maskDrawn(mask);
    }
    m_corners.clear();
    update();
}

void PhotoView::mousePressEvent(QMouseEvent* event) {
    setFocus(Qt::MouseFocusReason);
    m_grabbed = event->position();
    m_moved = false;
    m_pressed = true;
    m_drag = Drag::None;
    if (m_content.size.isEmpty()) {
        return;
    }
    const double line = frame().left() + m_swipe * frame().width();
    if (event->button() == Qt::LeftButton && m_show == Show::Swipe && m_tool == Tool::Look &&
        std::abs(event->position().x() - line) < near) {
        m_drag = Drag::Swipe;
    } else if (event->button() == Qt::LeftButton && m_tool == Tool::Look && markAt(m_grabbed) >= 0) {
        m_drag = Drag::Mark;
        m_dragged = markAt(m_grabbed);
        emit markChosen(m_dragged);
    } else if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && m_tool == Tool::Look)) {
        m_drag = Drag::Picture;
    }
}

void PhotoView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF off = event->position() - m_grabbed;
    m_moved = m_moved || off.manhattanLength() > 3.0;
    if (m_tool != Tool::Look) {
        m_cross = toPhotograph(event->position());
        m_hovered = true;
        update();
    }
    if (m_drag == Drag::Swipe) {
        setSwipe((event->position().x() - frame().left()) / frame().width());
        emit swipeMoved(m_swipe);
    } else if (m_drag == Drag::Mark && m_moved) {
        m_content.marks[static_cast<std::size_t>(m_dragged)].at = toPhotograph(event->position());
        update();
    } else if (m_drag == Drag::Picture && m_moved) {
        const QSizeF shown = frame().size();
        m_middle -= QPointF(off.x() / shown.width(), off.y() / shown.height());
        m_middle = {std::clamp(m_middle.x(), 0.0, 1.0), std::clamp(m_middle.y(), 0.0, 1.0)};
        m_grabbed = event->position();
        update();
    } else if (m_drag == Drag::None && m_tool == Tool::Look && m_show == Show::Swipe) {
        const double line = frame().left() + m_swipe * frame().width();
        setCursor(std::abs(event->position().x() - line) < near ? Qt::SplitHCursor : Qt::ArrowCursor);
    }
}

void PhotoView::leaveEvent(QEvent* event) {
    m_hovered = false;
    update();
    QWidget::leaveEvent(event);
}

void PhotoView::mouseReleaseEvent(QMouseEvent* event) {
    const Drag drag = m_drag;
    const bool pressed = std::exchange(m_pressed, false);
    m_drag = Drag::None;
    if (drag == Drag::Mark && m_moved) {
        emit markMoved(m_dragged, toPhotograph(event->position()));
    } else if (drag == Drag::Picture && !m_moved && event->button() == Qt::LeftButton) {
        emit maskChosen(maskAt(event->position()));
    } else if (m_tool != Tool::Look && event->button() == Qt::LeftButton && pressed && !m_moved) {
        use(toPhotograph(event->position()));
    }
}

void PhotoView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (m_tool == Tool::Mask && event->button() == Qt::LeftButton) {
        finishMask();
    } else if (m_tool == Tool::Look) {
        fit();
    }
}

bool PhotoView::event(QEvent* event) {
    return (m_tool != Tool::Look && keepsDrawingKeys(*event)) || QWidget::event(event);
}

void PhotoView::keyPressEvent(QKeyEvent* event) {
    const double step = ((event->modifiers() & Qt::ShiftModifier) != 0 ? 10.0 : 1.0) / scale();
    const auto move = [&](double dx, double dy) {
        m_cross = {std::clamp(m_cross.x() + dx, 0.0, static_cast<double>(m_content.size.width())),
                   std::clamp(m_cross.y() + dy, 0.0, static_cast<double>(m_content.size.height()))};
        m_crossShown = true;
        update();
    };
    const bool tool = m_tool != Tool::Look && !m_content.size.isEmpty();
    const int key = event->key();
    if (key == Qt::Key_Plus || key == Qt::Key_Equal || key == Qt::Key_Minus) {
        zoomAt(m_crossShown ? toWidget(m_cross) : QPointF(rect().center()), key == Qt::Key_Minus ? 1.0 / 1.2 : 1.2);
    } else if (key == Qt::Key_0) {
        fit();
    } else if (tool && key == Qt::Key_Left) {
        move(-step, 0.0);
    } else if (tool && key == Qt::Key_Right) {
        move(step, 0.0);
    } else if (tool && key == Qt::Key_Up) {
        move(0.0, -step);
    } else if (tool && key == Qt::Key_Down) {
        move(0.0, step);
    } else if (tool && key == Qt::Key_Space) {
        use(m_cross);
    } else if (tool && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
        m_tool == Tool::Mask&& m_corners.size() >= 3 ? finishMask() : use(m_cross);
    } else if (tool && key == Qt::Key_Backspace && !m_corners.empty()) {
        m_corners.pop_back();
        update();
    } else if (tool && key == Qt::Key_Escape) {
        if (m_corners.empty()) {
            emit toolLeft();
        }
        m_corners.clear();
        update();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void PhotoView::paintPictures(QPainter& painter) const {
    const QRectF where = frame();
    painter.setRenderHint(QPainter::SmoothPixmapTransform, scale() * m_content.size.width() < 4.0 * m_content.picture.width());
    painter.drawImage(where, m_content.picture);
    if (m_overlay.isNull()) {
        return;
    }
    if (m_show == Show::Swipe) {
        const double line = where.left() + m_swipe * where.width();
        painter.save();
        painter.setClipRect(QRectF(QPointF(line, where.top()), where.bottomRight()));
        painter.drawImage(where, m_overlay);
        painter.restore();
        const double middle = std::clamp(where.center().y(), 24.0, height() - 24.0);
        painter.setPen(QPen(Qt::white, 2.0));
        painter.drawLine(QPointF(line, where.top()), QPointF(line, where.bottom()));
        painter.setPen(QPen(QColor(0x33, 0x33, 0x33), 1.5));
        painter.setBrush(Qt::white);
        painter.drawEllipse(QPointF(line, middle), 12.0, 12.0);
        for (const double side : {-1.0, 1.0}) {
            painter.drawPolyline(QPolygonF({QPointF(line + 3.0 * side, middle - 4.0), QPointF(line + 7.0 * side, middle),
                                            QPointF(line + 3.0 * side, middle + 4.0)}));
        }
    } else if (m_show == Show::Blend || (m_show == Show::Blink && m_blinkOn)) {
        painter.setOpacity(m_show == Show::Blend ? m_blend : 1.0);
        painter.drawImage(where, m_overlay);
        painter.setOpacity(1.0);
    }
}

void PhotoView::paintMasks(QPainter& painter) const {
    for (std::size_t i = 0; i < m_content.masks.size(); ++i) {
        const PhotoMask& mask = m_content.masks[i];
        const bool chosen = static_cast<int>(i) == m_content.chosenMask;
        QColor tint = maskColour(mask.kind);
        tint.setAlphaF(chosen ? 0.3F : 0.12F);
        painter.setBrush(tint);
        // A dark line below keeps the bright one legible on a bright picture.
        painter.setPen(QPen(QColor(0, 0, 0, 130), chosen ? 5.0 : 4.0));
        const QPolygonF polygon = polygonOf(*this, mask.corners);
        painter.drawPolygon(polygon);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(maskPen(mask.kind, chosen));
        painter.drawPolygon(polygon);
    }
    if (m_show == Show::Outline) {
        painter.setBrush(Qt::NoBrush);
        for (const QPen& pen : {QPen(QColor(0, 0, 0, 130), 3.5), QPen(tints().fragment, 2.0)}) {
            painter.setPen(pen);
            for (const auto& ring : m_content.outlines) {
                painter.drawPolygon(polygonOf(*this, ring));
            }
        }
    }
    if (m_tool == Tool::Mask && !m_corners.empty()) {
        QPolygonF line = polygonOf(*this, m_corners);
        for (const QPointF& corner : line) {
            painter.setPen(QPen(Qt::black, 1.0));
            painter.setBrush(Qt::white);
            painter.drawRect(QRectF(corner - QPointF(3.0, 3.0), QSizeF(6.0, 6.0)));
        }
        line << toWidget(m_cross);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(maskPen(m_kind, true));
        painter.drawPolyline(line);
    }
}

void PhotoView::paintMarks(QPainter& painter) const {
    const figures::Palette& colours = figures::palette(render::Theme::Light);
    painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 0; i < m_content.marks.size(); ++i) {
        const PhotoMark& mark = m_content.marks[i];
        const QPointF at = toWidget(mark.at);
        if (mark.projected) {
            const QPointF there = toWidget(*mark.projected);
            painter.setPen(QPen(QColor(255, 255, 255, 200), 3.5));
            painter.drawLine(at, there);
            painter.setPen(QPen(mark.used ? colours.accent : colours.finding, 1.5, mark.used ? Qt::SolidLine : Qt::DashLine));
            painter.drawLine(at, there);
            painter.drawEllipse(there, 3.0, 3.0);
        }
        paintPointMark(painter, at, i + 1, mark.used, static_cast<int>(i) == m_content.chosenMark);
    }
    if (m_content.pending) {
        paintPendingPoint(painter, toWidget(*m_content.pending));
    }
    if (m_crossShown && m_tool != Tool::Look) {
        paintCross(painter, toWidget(m_cross), Qt::black, Qt::white, 19.0, 1.0);
    }
}

std::optional<QPointF> PhotoView::loupe() const {
    if (m_tool != Tool::Point || m_content.picture.isNull() || !(m_crossShown || m_hovered)) {
        return std::nullopt;
    }
    return loupeMiddle(QRectF(rect()), toWidget(m_cross));
}

void PhotoView::paintChips(QPainter& painter) const {
    painter.setFont(textFont());
    const bool over =
        !m_overlay.isNull() && (m_show == Show::Swipe || m_show == Show::Blend || (m_show == Show::Blink && m_blinkOn));
    if (m_show != Show::Blink || !over) {
        paintChip(painter, m_content.title, {8.0, 8.0}, Qt::AlignLeft);
    }
    if (over || (m_show == Show::Outline && !m_content.outlines.empty())) {
        paintChip(painter, m_overlayCaption, {width() - 8.0, 8.0}, Qt::AlignRight);
    }
}

void PhotoView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), tints().window);
    if (m_content.picture.isNull()) {
        painter.setPen(tints().muted);
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         m_content.title.isEmpty()
                             ? tr("Photographs of the site appear here: drop them on the window, or add them at the left.")
                             : m_content.title);
        return;
    }
    paintPictures(painter);
    paintMasks(painter);
    paintMarks(painter);
    paintChips(painter);
    if (loupe()) {
        paintLoupe(painter, QRectF(rect()), toWidget(m_cross), [this](QPainter& inside) { paintPictures(inside); });
    }
}

}  // namespace rubble::widgets
