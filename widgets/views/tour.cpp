#include "widgets/views/tour.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/basics/theme.h"

namespace rubble::widgets {

namespace {

constexpr int cardWidth = 340;
constexpr int margin = 14;

}  // namespace

Tour::Tour(std::vector<TourStop> stops, QWidget* window)
    : QWidget(window),
      m_stops(std::move(stops)),
      m_card(new QFrame(this)),
      m_title(new QLabel),
      m_words(new QLabel),
      m_count(new QLabel),
      m_back(new QPushButton(tr("Back"))),
      m_next(new QPushButton(tr("Next"))) {
    setAccessibleName(tr("Tour of the window"));
    setFocusPolicy(Qt::StrongFocus);
    hide();
    m_card->setObjectName(QStringLiteral("tourCard"));
    m_card->setFixedWidth(cardWidth);
    auto* column = new QVBoxLayout(m_card);
    column->setContentsMargins(16, 14, 16, 14);
    column->setSpacing(8);
    m_title->setFont(titleFont());
    m_words->setWordWrap(true);
    m_count->setObjectName(QStringLiteral("muted"));
    column->addWidget(m_title);
    column->addWidget(m_words);
    auto* row = new QHBoxLayout;
    auto* skip = new QPushButton(tr("End"));
    skip->setToolTip(tr("End the tour (Esc); the Help menu has it again"));
    m_back->setToolTip(tr("The stop before (←)"));
    m_next->setToolTip(tr("The next stop (→)"));
    m_next->setObjectName(QStringLiteral("primary"));
    row->addWidget(m_count, 1);
    row->addWidget(skip);
    row->addWidget(m_back);
    row->addWidget(m_next);
    column->addLayout(row);
    connect(skip, &QPushButton::clicked, this, [this] { go(-1); });
    connect(m_back, &QPushButton::clicked, this, [this] { go(m_current - 1); });
    connect(m_next, &QPushButton::clicked, this, [this] { go(m_current + 1); });
    window->installEventFilter(this);
}

void Tour::start() {
    go(0);
}

void Tour::go(int stop) {
    if (stop < 0 || stop >= static_cast<int>(m_stops.size())) {
        m_current = -1;
        hide();
        emit ended();
        return;
    }
    m_current = stop;
    const TourStop& at = m_stops[static_cast<std::size_t>(stop)];
    m_title->setText(at.title);
    m_words->setText(at.words);
    m_count->setText(tr("%1 of %2").arg(stop + 1).arg(m_stops.size()));
    m_back->setEnabled(stop > 0);
    m_next->setText(stop + 1 < static_cast<int>(m_stops.size()) ? tr("Next") : tr("Done"));
    show();
    raise();
    place();
    // Words have their final size once the card has been shown.
    QMetaObject::invokeMethod(this, &Tour::place, Qt::QueuedConnection);
    // Reached as if by the keyboard, so that Space pushes it.
    m_next->setFocus(Qt::TabFocusReason);
    setAccessibleDescription(at.title + QStringLiteral(". ") + at.words);
    update();
}

QRect Tour::partRect() const {
    const QWidget* part = m_current >= 0 ? m_stops[static_cast<std::size_t>(m_current)].part.data() : nullptr;
    if (part == nullptr || !part->isVisible()) {
        return {};
    }
    return QRect(part->mapTo(window(), QPoint(0, 0)), part->size()).adjusted(2, 2, -2, -2);
}

void Tour::place() {
    if (m_current < 0) {
        return;
    }
    setGeometry(parentWidget()->rect());
    m_card->layout()->invalidate();
    m_card->setFixedHeight(m_card->layout()->heightForWidth(cardWidth));
    const QRect part = partRect();
    const QRect room = rect().adjusted(margin, margin, -margin, -margin);
    const QSize card(cardWidth, m_card->height());
    // Beside the part where there is room: right, above, left, below; else in its middle.
    const std::array places = {QPoint(part.right() + margin, part.top()), QPoint(part.left(), part.top() - margin - card.height()),
                               QPoint(part.left() - margin - card.width(), part.top()),
                               QPoint(part.right() - card.width(), part.bottom() + margin)};
    QRect best(part.center() - QPoint(card.width() / 2, card.height() / 2), card);
    for (const QPoint& corner : places) {
        QRect there(corner, card);
        there.moveLeft(std::clamp(there.left(), room.left(), room.right() - card.width()));
        there.moveTop(std::clamp(there.top(), room.top(), room.bottom() - card.height()));
        if (!part.isNull() && !there.intersects(part)) {
            best = there;
            break;
        }
    }
    if (part.isNull()) {
        best.moveCenter(rect().center());
    }
    m_card->move(best.topLeft());
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize && m_current >= 0) {
        place();
    }
    return QWidget::eventFilter(watched, event);
}

void Tour::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath shade;
    shade.addRect(rect());
    const QRect part = partRect();
    QPainterPath hole;
    hole.addRoundedRect(part, 6, 6);
    painter.fillPath(part.isNull() ? shade : shade.subtracted(hole), QColor(0, 0, 0, 120));
    if (!part.isNull()) {
        painter.setPen(QPen(tints().accent, 2));
        painter.drawPath(hole);
    }
}

bool Tour::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        // Its keys are not those of the transport.
        switch (static_cast<QKeyEvent*>(event)->key()) {
            case Qt::Key_Left:
            case Qt::Key_Right:
            case Qt::Key_Space:
                event->accept();
                return true;
            default:
                break;
        }
    }
    return QWidget::event(event);
}

void Tour::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Escape:
            go(-1);
            break;
        case Qt::Key_Right:
        case Qt::Key_Return:
        case Qt::Key_Space:
            go(m_current + 1);
            break;
        case Qt::Key_Left:
            go(std::max(0, m_current - 1));
            break;
        default:
            QWidget::keyPressEvent(event);
    }
}

void Tour::mousePressEvent(QMouseEvent*) {
    go(m_current + 1);
}

}  // namespace rubble::widgets
