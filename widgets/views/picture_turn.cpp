#include "widgets/views/picture_turn.h"

#include <QCoreApplication>
#include <QEvent>
#include <algorithm>

namespace rubble::widgets {

namespace {

constexpr int nap = 5;  // ms, from one look to the next while input is recent
constexpr int picturesHeld = 2;

bool isInput(QEvent::Type type) {
    switch (type) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonRelease:
        case QEvent::MouseButtonDblClick:
        case QEvent::Wheel:
        case QEvent::KeyPress:
        case QEvent::KeyRelease:
        case QEvent::TouchBegin:
            return true;
        default:
            // Moves are not: with them playback would stand while somebody turns the model.
            return false;
    }
}

}  // namespace

PictureTurn::PictureTurn(QObject* parent) : QObject(parent) {
    for (QTimer* timer : {&m_idle, &m_drawn}) {
        timer->setSingleShot(true);
    }
    connect(&m_idle, &QTimer::timeout, this, &PictureTurn::look);
    connect(&m_drawn, &QTimer::timeout, this, [this] { m_cost = m_begun.elapsed(); });
    if (auto* program = QCoreApplication::instance()) {
        program->installEventFilter(this);
    }
}

void PictureTurn::ask() {
    if (!m_waits) {
        m_waits = true;
        m_asked.start();
        // A timer without an interval comes after all events that wait.
        m_idle.start(0);
        return;
    }
    ++m_dropped;
    if (m_asked.elapsed() >= longest) {
        look();
    }
}

void PictureTurn::drop() {
    m_waits = false;
    m_idle.stop();
}

bool PictureTurn::inputIsRecent() const {
    return m_input.isValid() && m_input.elapsed() < picturesHeld * m_cost;
}

void PictureTurn::look() {
    if (!m_waits) {
        return;
    }
    if (inputIsRecent() && m_asked.elapsed() < longest) {
        m_idle.start(nap);
        return;
    }
    drop();
    m_begun.start();
    m_drawn.start(0);
    emit due();
}

bool PictureTurn::eventFilter(QObject* watched, QEvent* event) {
    if (isInput(event->type())) {
        m_input.start();
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace rubble::widgets
