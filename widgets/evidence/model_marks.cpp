#include "widgets/evidence/model_marks.h"

#include <QMouseEvent>
#include <QPainter>

#include "widgets/basics/theme.h"
#include "widgets/evidence/point_marks.h"
#include "widgets/views/view_widget.h"

namespace rubble::widgets {

namespace {

constexpr int restMilliseconds = 80;
constexpr double clickMost = 3.0;  // px that a click may move

}  // namespace

ModelMarks::ModelMarks(ViewWidget& model) : QWidget(&model), m_model(model) {
    setObjectName(QStringLiteral("modelMarks"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    resize(model.size());
    model.installEventFilter(this);
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, &ModelMarks::takePicture);
    connect(&model, &ViewWidget::shown, this, [this] { update(); });
}

void ModelMarks::setContent(const Content& content) {
    m_content = content;
    update();
}

void ModelMarks::setPairs(const std::vector<PointPair>& pairs, const std::vector<bool>& used, int chosen,
                          const std::optional<Vec3>& pending) {
    Content content{{}, chosen, pending};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        content.marks.push_back({pairs[i].model, i >= used.size() || used[i]});
    }
    setContent(content);
}

void ModelMarks::setPicking(bool picking) {
    m_picking = picking;
    m_model.setMouseTracking(picking);
    m_mouse.reset();
    m_picture = {};
    update();
}

std::optional<QPointF> ModelMarks::placeOf(const Vec3& point) const {
    const render::View& view = m_model.view();
    const render::Pane pane = render::panesOf(view.layout, m_model.width(), m_model.height()).front();
    const auto place = render::project(render::cameraOf(view, pane.content), point, pane.aspect());
    if (!place) {
        return std::nullopt;
    }
    return QPointF(pane.x + place->u * pane.width, pane.y + place->v * pane.height);
}

std::optional<QPointF> ModelMarks::loupe() const {
    if (!m_picking || !m_mouse || !pictureIsNow()) {
        return std::nullopt;
    }
    return loupeMiddle(QRectF(rect()), *m_mouse);
}

bool ModelMarks::pictureIsNow() const {
    return !m_picture.isNull() && m_pictureOf == m_model.view() && m_picture.size() == m_model.size() * m_model.devicePixelRatioF();
}

void ModelMarks::takePicture() {
    if (m_picking && m_mouse && !pictureIsNow() && m_model.isVisible()) {
        m_picture = m_model.picture();
        m_pictureOf = m_model.view();
        update();
    }
}

void ModelMarks::noteClick(QEvent* event) {
    if (event->type() == QEvent::MouseButtonPress) {
        m_pressed = static_cast<QMouseEvent*>(event)->position();
    } else if (event->type() == QEvent::MouseButtonRelease) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        if (mouse->button() == Qt::LeftButton && (mouse->position() - m_pressed).manhattanLength() <= clickMost) {
            emit picked(mouse->position());
        }
    }
}

bool ModelMarks::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_model && m_picking) {
        noteClick(event);
    }
    if (watched == &m_model && event->type() == QEvent::Resize) {
        resize(m_model.size());
    } else if (watched == &m_model && m_picking && event->type() == QEvent::MouseMove) {
        m_mouse = static_cast<QMouseEvent*>(event)->position();
        if (!pictureIsNow()) {
            m_rest.start();
        }
        update();
    } else if (watched == &m_model && event->type() == QEvent::Leave) {
        m_mouse.reset();
        update();
    }
    return QWidget::eventFilter(watched, event);
}

void ModelMarks::paintMarks(QPainter& painter) const {
    for (std::size_t i = 0; i < m_content.marks.size(); ++i) {
        const Mark& mark = m_content.marks[i];
        if (const auto at = placeOf(mark.place)) {
            paintPointMark(painter, *at, i + 1, mark.used, static_cast<int>(i) == m_content.chosen);
        }
    }
    if (const auto at = m_content.pending ? placeOf(*m_content.pending) : std::nullopt) {
        paintPendingPoint(painter, *at);
    }
}

void ModelMarks::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(textFont());
    paintMarks(painter);
    if (loupe()) {
        paintLoupe(painter, QRectF(rect()), *m_mouse, [this](QPainter& inside) { inside.drawImage(QRectF(rect()), m_picture); });
    }
}

}  // namespace rubble::widgets
