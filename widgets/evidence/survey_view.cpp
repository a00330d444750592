#include "widgets/evidence/survey_view.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "widgets/basics/drawing_keys.h"
#include "widgets/basics/theme.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/survey_picture.h"

namespace rubble::widgets {

namespace {

constexpr int sideMin = 140;          // px
constexpr double scopeWidth = 2.0;    // px, of what is compared
constexpr double besideCorner = 3.0;  // px

}  // namespace

SurveyView::SurveyView(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Difference map of the survey"));
    setMinimumSize(sideMin, sideMin);
}

void SurveyView::setComparison(std::shared_ptr<const SurveyComparison> comparison) {
    if (comparison != m_comparison) {
        m_comparison = std::move(comparison);
        m_picture = QImage();
        if (m_comparison == nullptr) {
            draw(std::nullopt);
        }
        update();
    }
}

void SurveyView::setScope(const SurveyScope& scope) {
    if (!(scope == m_scope)) {
        m_scope = scope;
        update();
    }
}

void SurveyView::setMarked(const Outline& removed, const std::optional<SectionLine>& section) {
    m_removed = removed;
    m_section = section;
    update();
}

void SurveyView::draw(std::optional<Draws> what) {
    const bool ends = m_drawing && !what;
    m_drawing = m_comparison != nullptr ? what : std::nullopt;
    m_corners.clear();
    m_cross = rect().center();
    setCursor(m_drawing ? Qt::CrossCursor : Qt::ArrowCursor);
    setMouseTracking(m_drawing.has_value());
    setFocusPolicy(m_drawing ? Qt::StrongFocus : Qt::NoFocus);
    if (m_drawing) {
        setFocus();
    }
    update();
    if (ends) {
        emit left();
    }
}

QPointF SurveyView::toWidget(const Eigen::Vector2d& place) const {
    return m_field.toPicture(place);
}

void SurveyView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange || event->type() == QEvent::LanguageChange) {
        m_picture = QImage();
        update();
    }
}

void SurveyView::resizeEvent(QResizeEvent*) {
    m_picture = QImage();
    update();
}

void SurveyView::drawPicture() {
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
    figures::SurveyPictureStyle style;
    style.pixels = pixels;
    style.textPixels = devicePixelRatioF() * fontMetrics().ascent();
    style.theme = currentTheme();
    style.scope = false;  // what is compared is drawn as it is now, not as it was
    m_picture = figures::surveyPicture(*m_comparison, style);
    m_picture.setDevicePixelRatio(devicePixelRatioF());
    m_field = figures::surveyField(*m_comparison, style);
    m_field.frame = QRectF(m_field.frame.topLeft() / devicePixelRatioF(), m_field.frame.size() / devicePixelRatioF());
}

void SurveyView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const auto& palette = figures::palette(currentTheme());
    painter.fillRect(rect(), palette.window);
    if (m_comparison == nullptr) {
        painter.setPen(palette.muted);
        painter.drawText(rect().adjusted(40, 40, -40, -40), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("The difference map of a survey stands here: add a survey in the panel and compare."));
        return;
    }
    if (m_picture.isNull()) {
        drawPicture();
    }
    painter.drawImage(QPoint(0, 0), m_picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.setClipRect(m_field.frame);
    figures::drawScope(painter, m_field, m_scope, scopeWidth);
    paintMarked(painter);
    painter.restore();
    paintDrawing(painter);
}

void SurveyView::paintMarked(QPainter& painter) const {
    const auto& palette = figures::palette(currentTheme());
    painter.setPen(QPen(palette.text, scopeWidth, Qt::DashDotLine));
    painter.setBrush(QBrush(palette.text, Qt::FDiagPattern));
    for (const OutlinePolygon& polygon : m_removed.polygons) {
        for (const OutlineRing& ring : polygon) {
            QPolygonF corners;
            for (const Eigen::Vector2d& corner : ring) {
                corners << m_field.toPicture(corner);
            }
            painter.drawPolygon(corners);
        }
    }
    if (m_section) {
        const QPointF from = m_field.toPicture(m_section->from);
        const QPointF to = m_field.toPicture(m_section->to);
        painter.setPen(QPen(palette.text, scopeWidth));
        painter.drawLine(from, to);
        painter.setBrush(palette.window);
        painter.drawEllipse(from, besideCorner, besideCorner);
    }
}

QString SurveyView::drawingHint() const {
    switch (*m_drawing) {
        case Draws::Area:
            return tr("Click around what is compared; double-click or Enter closes, Backspace takes one back, Esc ends.");
        case Draws::LeftOut:
            return tr("Click around what is left out; double-click or Enter closes, Backspace takes one back, Esc ends.");
        case Draws::Removed:
            return tr("Click around what was removed; double-click or Enter closes, Backspace takes one back, Esc ends.");
        case Draws::Section:
            break;
    }
    return tr("Click where the section begins, then where it ends; Backspace takes one back, Esc ends.");
}

void SurveyView::paintDrawing(QPainter& painter) const {
    if (!m_drawing) {
        return;
    }
    const auto& palette = figures::palette(currentTheme());
    painter.setPen(QPen(palette.text, 1.5, *m_drawing == Draws::LeftOut ? Qt::DotLine : Qt::SolidLine));
    painter.setBrush(Qt::NoBrush);
    QPolygonF line;
    for (const Eigen::Vector2d& corner : m_corners) {
        line << m_field.toPicture(corner);
        painter.drawEllipse(line.back(), 3.0, 3.0);
    }
    line << m_cross;
    painter.drawPolyline(line);
    painter.drawLine(m_cross - QPointF(6.0, 0.0), m_cross + QPointF(6.0, 0.0));
    painter.drawLine(m_cross - QPointF(0.0, 6.0), m_cross + QPointF(0.0, 6.0));
    const QString hint = drawingHint();
    const QRect box =
        painter.fontMetrics().boundingRect(rect().adjusted(12, 8, -12, -8), Qt::TextWordWrap, hint).adjusted(-6, -3, 6, 3);
    painter.fillRect(box, palette.window);
    painter.drawText(box.adjusted(6, 3, -6, -3), Qt::TextWordWrap, hint);
}

void SurveyView::addCorner(const QPointF& at) {
    const Eigen::Vector2d place = m_field.toPlace(at);
    // The second press of a double click is no corner of its own.
    if (m_corners.empty() || (m_field.toPicture(m_corners.back()) - at).manhattanLength() > besideCorner) {
        m_corners.push_back(place);
    }
    m_cross = at;
    update();
    if (m_drawing == Draws::Section && m_corners.size() == 2) {
        close();
    }
}

void SurveyView::close() {
    const std::size_t least = m_drawing == Draws::Section ? 2 : 3;
    if (!m_drawing || m_corners.size() < least) {
        return;
    }
    const Draws what = *m_drawing;
    const OutlineRing ring = m_corners;
    draw(std::nullopt);
    emit drawn(what, ring);
}

void SurveyView::mousePressEvent(QMouseEvent* event) {
    if (m_drawing && event->button() == Qt::LeftButton && m_field.frame.contains(event->position())) {
        addCorner(event->position());
    }
}

void SurveyView::mouseMoveEvent(QMouseEvent* event) {
    if (m_drawing) {
        m_cross = event->position();
        update();
    }
}

void SurveyView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (m_drawing && event->button() == Qt::LeftButton) {
        close();
    }
}

bool SurveyView::event(QEvent* event) {
    return (m_drawing.has_value() && keepsDrawingKeys(*event)) || QWidget::event(event);
}

void SurveyView::keyPressEvent(QKeyEvent* event) {
    const double step = (event->modifiers() & Qt::ShiftModifier) != 0 ? 10.0 : 1.0;
    const auto move = [&](double dx, double dy) {
        m_cross = {std::clamp(m_cross.x() + dx * step, m_field.frame.left(), m_field.frame.right()),
                   std::clamp(m_cross.y() + dy * step, m_field.frame.top(), m_field.frame.bottom())};
        update();
    };
    if (!m_drawing) {
        QWidget::keyPressEvent(event);
        return;
    }
    switch (event->key()) {
        case Qt::Key_Left:
            return move(-1.0, 0.0);
        case Qt::Key_Right:
            return move(1.0, 0.0);
        case Qt::Key_Up:
            return move(0.0, -1.0);
        case Qt::Key_Down:
            return move(0.0, 1.0);
        case Qt::Key_Space:
            return addCorner(m_cross);
        case Qt::Key_Return:
        case Qt::Key_Enter:
            return close();
        case Qt::Key_Backspace:
            if (!m_corners.empty()) {
                m_corners.pop_back();
            }
            return update();
        case Qt::Key_Escape:
            return draw(std::nullopt);
        default:
            return QWidget::keyPressEvent(event);
    }
}

}  // namespace rubble::widgets
