#include "widgets/views/tour.h"

#include <QApplication>
#include <QFrame>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

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
      m_skip(new QPushButton(tr("Skip"))),
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
    m_skip->setObjectName(QStringLiteral("tourSkip"));
    m_skip->setToolTip(tr("End the tour (Esc); the Help menu has it again"));
    m_back->setObjectName(QStringLiteral("tourBack"));
    m_back->setToolTip(tr("The stop before (←)"));
    m_next->setToolTip(tr("The next stop (→)"));
    m_next->setObjectName(QStringLiteral("primary"));
    row->addWidget(m_count, 1);
    for (QPushButton* button : {m_skip, m_back, m_next}) {
        button->installEventFilter(this);
        row->addWidget(button);
    }
    column->addLayout(row);
    connect(m_skip, &QPushButton::clicked, this, [this] { go(-1); });
    connect(m_back, &QPushButton::clicked, this, [this] { go(m_current - 1); });
    connect(m_next, &QPushButton::clicked, this, [this] { go(m_current + 1); });
    window->installEventFilter(this);
    // A run that begins chooses its panel, and who looks at the tour would be left without its keys.
    connect(qApp, &QApplication::focusChanged, this, [this](const QWidget*, const QWidget* now) {
        const bool left = now == nullptr || (now->window() == this->window() && !isAncestorOf(now));
        if (m_current >= 0 && left && this->window()->isActiveWindow() && QApplication::activePopupWidget() == nullptr) {
            QMetaObject::invokeMethod(this, &Tour::takeFocus, Qt::QueuedConnection);
        }
    });
}

void Tour::takeFocus() {
    if (m_current >= 0 && !isAncestorOf(QApplication::focusWidget()) && QApplication::activeModalWidget() == nullptr) {
        m_next->setFocus(Qt::TabFocusReason);
    }
}

void Tour::start() {
    go(0);
}

void Tour::go(int stop) {
    if (stop < 0 || stop >= static_cast<int>(m_stops.size())) {
        m_current = -1;
        // What goes with the focus would hand it on to some field.
        parentWidget()->setFocus(Qt::OtherFocusReason);
        hide();
        emit ended();
        return;
    }
    m_current = stop;
    tell(m_stops[static_cast<std::size_t>(stop)]);
    show();
    raise();
    place();
    // Words have their final size once the card has been shown.
    QMetaObject::invokeMethod(this, &Tour::place, Qt::QueuedConnection);
    // Reached as if by the keyboard, so that Space pushes it.
    m_next->setFocus(Qt::TabFocusReason);
    update();
}

void Tour::tell(const TourStop& stop) {
    const bool last = m_current + 1 == static_cast<int>(m_stops.size());
    m_title->setText(stop.title);
    m_words->setText(stop.words);
    m_count->setText(tr("%1 of %2").arg(m_current + 1).arg(m_stops.size()));
    m_back->setEnabled(m_current > 0);
    m_skip->setVisible(!last);
    m_next->setText(last ? tr("Done") : tr("Next"));
    const QString all = QStringLiteral("%1, %2. %3").arg(m_count->text(), stop.title, stop.words);
    setAccessibleDescription(all);
    // A screen reader speaks of what has the focus.
    m_next->setAccessibleDescription(all);
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
    m_card->setFixedHeight(m_card->heightForWidth(cardWidth));
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
    const bool key = event->type() == QEvent::KeyPress && watched != parentWidget();
    return (key && takesKey(*static_cast<QKeyEvent*>(event), watched)) || QWidget::eventFilter(watched, event);
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
            case Qt::Key_Return:
            case Qt::Key_Enter:
                event->accept();
                return true;
            default:
                break;
        }
    }
    return QWidget::event(event);
}

void Tour::keyPressEvent(QKeyEvent* event) {
    if (!takesKey(*event, this)) {
        QWidget::keyPressEvent(event);
    }
}

bool Tour::takesKey(const QKeyEvent& key, QObject* on) {
    auto* button = qobject_cast<QPushButton*>(on);
    switch (key.key()) {
        case Qt::Key_Escape:
            go(-1);
            return true;
        case Qt::Key_Right:
            go(m_current + 1);
            return true;
        case Qt::Key_Left:
            go(std::max(0, m_current - 1));
            return true;
        case Qt::Key_Space:
        case Qt::Key_Return:
        case Qt::Key_Enter:
            (button != nullptr ? button : m_next)->click();
            return true;
        default:
            return false;
    }
}

bool Tour::focusNextPrevChild(bool next) {
    const std::array buttons{m_skip, m_back, m_next};
    const auto count = static_cast<int>(buttons.size());
    int at = static_cast<int>(std::find(buttons.begin(), buttons.end(), focusWidget()) - buttons.begin());
    for (int step = 0; step < count; ++step) {
        at = (at + (next ? 1 : count - 1)) % count;
        QPushButton* button = buttons[static_cast<std::size_t>(at)];
        if (button->isEnabled() && button->isVisible()) {
            button->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
            break;
        }
    }
    return true;
}

void Tour::mousePressEvent(QMouseEvent*) {
    go(m_current + 1);
}

}  // namespace rubble::widgets
