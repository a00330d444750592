#include "widgets/views/timeline.h"

#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/basics/icons.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/number_text.h"

namespace rubble::widgets {

Timeline::Timeline(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
    setAccessibleName(tr("Timeline"));
    setToolTip(
        tr("Deaths over time, those in islands that the engine carried, and what is computed. Drag to scrub; with Shift, drag the "
           "range that playback goes round."));
}

Timeline::Rows Timeline::rows() const {
    const auto wide = [this](const QString& words) { return static_cast<double>(fontMetrics().horizontalAdvance(words)); };
    const double row = eventless() ? 0.0 : wide(mixed() ? tr("events") : tr("bookmarks"));
    const double label = std::max(wide(tr("computed")), row) + 24.0;
    const double axis = height() - fontMetrics().height() - 10.0;
    const double signs = m_marks.empty() ? 0.0 : 18.0;
    const double flags = eventless() ? 0.0 : bookmarkRow;
    const double bar = axis - 8.0 - signs - flags;
    return {label, width() - 24.0, 12.0, bar - 16.0, bar - 8.0, bar, axis - 9.0 - signs, axis - 10.0, axis};
}

void Timeline::setRange(double first, double last) {
    m_first = first;
    m_last = std::max(first, last);
    groupSigns();
    update();
}

void Timeline::setDeaths(std::vector<double> times, std::vector<double> deaths) {
    m_times = std::move(times);
    m_deaths = std::move(deaths);
    update();
}

void Timeline::setIslands(std::vector<double> deaths, std::vector<HandOverMark> handOvers) {
    m_islandDeaths = std::move(deaths);
    m_handOvers = std::move(handOvers);
    update();
}

void Timeline::setFeEnd(double time) {
    m_feEnd = time;
    update();
}

void Timeline::setComputed(double first, double last, bool stale) {
    m_computedFirst = first;
    m_computedLast = last;
    m_stale = stale;
    update();
}

void Timeline::setTime(double time) {
    m_time = time;
    update();
}

void Timeline::setHealth(std::vector<HealthMark> marks) {
    m_marks = std::move(marks);
    groupSigns();
    QStringList titles;
    for (const HealthMark& mark : m_marks) {
        titles << tr("%1 from %2 to %3").arg(mark.title, figures::timeText(mark.from), figures::timeText(mark.to));
    }
    setAccessibleDescription(titles.isEmpty() ? QString() : tr("Limits passed: %1").arg(inOneLine(titles)));
    update();
}

void Timeline::groupSigns() {
    constexpr double width = 15.0;
    m_signs.clear();
    for (std::size_t i = 0; i < m_marks.size(); ++i) {
        if (!m_signs.empty() && toX(m_marks[i].from) - toX(m_marks[m_signs.back().first].from) < width) {
            m_signs.back().last = i;
        } else {
            m_signs.push_back({i, i});
        }
    }
}

QPointF Timeline::signOf(std::size_t mark) const {
    std::size_t first = mark;
    for (const Sign& sign : m_signs) {
        if (sign.first <= mark && mark <= sign.last) {
            first = sign.first;
        }
    }
    return {toX(m_marks[first].from), rows().health};
}

std::vector<std::size_t> Timeline::marksAt(const QPointF& point) const {
    std::vector<std::size_t> found;
    const Rows r = rows();
    if (m_marks.empty() || std::abs(point.y() - r.health) > 9.0) {
        return found;
    }
    for (const Sign& sign : m_signs) {
        if (std::abs(point.x() - toX(m_marks[sign.first].from)) <= 8.0) {
            for (std::size_t i = sign.first; i <= sign.last; ++i) {
                found.push_back(i);
            }
            return found;
        }
    }
    for (std::size_t i = 0; i < m_marks.size(); ++i) {
        if (point.x() >= toX(m_marks[i].from) - 2.0 && point.x() <= toX(m_marks[i].to) + 2.0) {
            found.push_back(i);
        }
    }
    return found;
}

QString Timeline::wordsOf(const std::vector<std::size_t>& marks) const {
    QStringList words;
    for (const std::size_t i : marks) {
        words << m_marks[i].words;
    }
    return words.join(QStringLiteral("<hr/>"));
}

bool Timeline::showToolTip(const QPointF& point, const QPoint& global) {
    QString text;
    if (const auto bookmark = bookmarkAt(point)) {
        const TimeMark& mark = m_bookmarks[*bookmark];
        const QString note = mark.note.isEmpty() ? tr("Bookmark") : mark.note;
        text = tr("%1\n%2; double-click to change").arg(note, shownTime(mark.time));
    } else if (const auto photograph = photographAt(point)) {
        const PhotographTime& mark = m_photographs[*photograph];
        text = tr("Photograph %1\n%2 ± %3").arg(mark.name, shownTime(mark.time), shownWith(mark.uncertainty, "s"));
    } else if (const auto marks = marksAt(point); !marks.empty()) {
        text = wordsOf(marks);
    } else if (const auto handOver = handOverAt(point)) {
        const HandOverMark& mark = m_handOvers[*handOver];
        text = QStringLiteral("%1: %2").arg(shownTime(mark.time), mark.words);
    } else {
        return false;
    }
    QToolTip::showText(global, text, this);
    return true;
}

bool Timeline::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (showToolTip(help->pos(), help->globalPos())) {
            return true;
        }
    }
    return QWidget::event(event);
}

void Timeline::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    groupSigns();
}

void Timeline::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_last <= m_first) {
        return;
    }
    if (const auto marks = marksAt(event->position()); !marks.empty()) {
        emit markChosen(marks.front());
        return;
    }
    if (const auto bookmark = bookmarkAt(event->position())) {
        emit bookmarkChosen(*bookmark);
        return;
    }
    if (const auto photograph = photographAt(event->position())) {
        emit scrubbed(m_photographs[*photograph].time);
        return;
    }
    if (const auto handOver = handOverAt(event->position())) {
        emit scrubbed(m_handOvers[*handOver].time);
        return;
    }
    if ((event->modifiers() & Qt::ShiftModifier) != 0) {
        m_loopStart = toTime(event->position().x());
        return;
    }
    m_scrubbing = true;
    emit scrubbed(toTime(event->position().x()));
}

void Timeline::mouseDoubleClickEvent(QMouseEvent* event) {
    if (const auto bookmark = bookmarkAt(event->position()); bookmark && event->button() == Qt::LeftButton) {
        emit bookmarkOpened(*bookmark);
    } else {
        mousePressEvent(event);
    }
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
    if (m_scrubbing && (event->buttons() & Qt::LeftButton) != 0 && m_last > m_first) {
        emit scrubbed(toTime(event->position().x()));
    } else if (m_loopStart && (event->buttons() & Qt::LeftButton) != 0) {
        const double now = toTime(event->position().x());
        emit loopDragged(std::min(*m_loopStart, now), std::max(*m_loopStart, now), false);
    }
}

void Timeline::mouseReleaseEvent(QMouseEvent* event) {
    m_scrubbing = false;
    if (m_loopStart) {
        const double now = toTime(event->position().x());
        emit loopDragged(std::min(*m_loopStart, now), std::max(*m_loopStart, now), true);
        m_loopStart.reset();
    }
}

void Timeline::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(headingFont());
    const Rows r = rows();
    painter.setPen(tints().muted);
    if (m_last <= m_first) {
        painter.drawText(rect(), Qt::AlignCenter, tr("The timeline appears when a result is open."));
        return;
    }
    painter.drawText(QPointF(12, r.deathsTop + painter.fontMetrics().ascent()), tr("deaths"));
    painter.drawText(QPointF(12, r.barBottom), tr("computed"));
    paintLoop(painter, r);
    painter.setPen(tints().muted);
    paintDeaths(painter, r);
    paintHandOvers(painter, r);
    paintComputed(painter, r);
    paintAxis(painter, r);
    if (!m_marks.empty()) {
        painter.setPen(tints().muted);
        painter.drawText(QPointF(12, r.health + painter.fontMetrics().ascent() / 2.0 - 1.0), tr("health"));
        paintHealth(painter, r);
    }
    paintBookmarks(painter, r);
    paintMarks(painter, r);
}

void Timeline::paintHealth(QPainter& painter, const Rows& r) const {
    for (const HealthMark& mark : m_marks) {
        QColor wash = mark.acknowledged ? tints().muted : tints().finding;
        painter.setPen(Qt::NoPen);
        wash.setAlphaF(0.09F);
        const QRectF column(QPointF(toX(mark.from), r.deathsTop - 4.0),
                            QPointF(std::max(toX(mark.to), toX(mark.from) + 2.0), r.barTop - 2.0));
        painter.fillRect(column, wash);
        wash.setAlphaF(0.75F);
        painter.setBrush(wash);
        painter.drawRoundedRect(QRectF(QPointF(column.left(), r.health - 2.0), QPointF(column.right(), r.health + 2.0)), 2, 2);
    }
    painter.setBrush(Qt::NoBrush);
    for (const Sign& sign : m_signs) {
        bool acknowledged = true;
        for (std::size_t i = sign.first; i <= sign.last; ++i) {
            acknowledged = acknowledged && m_marks[i].acknowledged;
        }
        const QPointF centre(toX(m_marks[sign.first].from), r.health);
        // The mark in the sign is a hole: no bar is to be seen through it.
        painter.fillRect(QRectF(centre.x() - 2.0, r.health - 3.0, 4.0, 8.0), tints().panel);
        painter.setPen(acknowledged ? tints().muted : tints().finding);
        drawGlyph(painter, Glyph::Finding, QRect(qRound(centre.x()) - 8, qRound(centre.y()) - 8, 16, 16));
        if (sign.last > sign.first) {
            painter.drawText(QPointF(centre.x() + 10.0, r.health - 3.0), QString::number(sign.last - sign.first + 1));
        }
    }
}

void Timeline::paintDeaths(QPainter& painter, const Rows& r) const {
    const double most = m_deaths.empty() ? 0.0 : *std::max_element(m_deaths.begin(), m_deaths.end());
    if (most <= 0.0) {
        painter.drawText(QPointF(r.left, r.deathsBottom - 4), tr("no element dies in this result"));
        return;
    }
    const auto paint = [&](const std::vector<double>& deaths, const QColor& colour) {
        QPainterPath outline(QPointF(toX(m_times.front()), r.deathsBottom));
        for (std::size_t i = 0; i < m_times.size() && i < deaths.size(); ++i) {
            outline.lineTo(toX(m_times[i]), r.deathsBottom - (r.deathsBottom - r.deathsTop) * deaths[i] / most);
        }
        QPainterPath area = outline;
        area.lineTo(toX(m_times.back()), r.deathsBottom);
        area.closeSubpath();
        QColor wash = colour;
        wash.setAlphaF(0.25F);
        painter.fillPath(area, wash);
        painter.setPen(QPen(colour, 1.3));
        painter.drawPath(outline);
    };
    paint(m_deaths, tints().fragment);
    const bool inIslands = std::any_of(m_islandDeaths.begin(), m_islandDeaths.end(), [](double deaths) { return deaths > 0.0; });
    if (inIslands) {
        paint(m_islandDeaths, tints().released);
        painter.drawText(QPointF(12, r.deathsTop + painter.fontMetrics().height() + painter.fontMetrics().ascent()),
                         tr("in islands"));
    }
}

QPointF Timeline::tickOf(std::size_t handOver) const {
    return {toX(m_handOvers[handOver].time), rows().deathsBottom + 4.0};
}

std::optional<std::size_t> Timeline::handOverAt(const QPointF& point) const {
    constexpr double reach = 4.0;  // px
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < m_handOvers.size(); ++i) {
        const QPointF away = point - tickOf(i);
        const bool hit = std::abs(away.x()) <= reach && std::abs(away.y()) <= reach;
        if (hit && (!nearest || std::abs(away.x()) < std::abs(point.x() - tickOf(*nearest).x()))) {
            nearest = i;
        }
    }
    return nearest;
}

void Timeline::paintHandOvers(QPainter& painter, const Rows& r) const {
    painter.setPen(QPen(tints().released, 1.6));
    for (const HandOverMark& mark : m_handOvers) {
        const double x = toX(mark.time);
        painter.drawLine(QPointF(x, r.deathsBottom + 1.0), QPointF(x, r.deathsBottom + 7.0));
    }
}

void Timeline::paintPeak(QPainter& painter, const Rows& r) const {
    const auto peak = std::max_element(m_deaths.begin(), m_deaths.end());
    if (peak == m_deaths.end() || *peak <= 0.0) {
        return;
    }
    const QString label = tr("%1 in one state").arg(shownCount(static_cast<std::int64_t>(*peak)));
    paintCaption(painter, r, toX(m_times[static_cast<std::size_t>(peak - m_deaths.begin())]), 8.0, label);
}

/// Right of its place, and left of it where the row ends.
void Timeline::paintCaption(QPainter& painter, const Rows& r, double at, double gap, const QString& text) const {
    const double width = painter.fontMetrics().horizontalAdvance(text);
    const double left = at + gap + width > r.right ? at - gap - width : at + gap;
    const QRectF room(left, r.deathsTop - 2.0, width, painter.fontMetrics().height());
    // The cursor and the curve go through the room of a caption.
    painter.setPen(Qt::NoPen);
    painter.setBrush(tints().panel);
    painter.drawRoundedRect(room.adjusted(-3, 0, 3, 0), 2, 2);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(tints().muted);
    painter.drawText(QPointF(left, room.top() + painter.fontMetrics().ascent()), text);
}

void Timeline::paintComputed(QPainter& painter, const Rows& r) const {
    painter.setPen(Qt::NoPen);
    painter.setBrush(tints().hairline);
    painter.drawRoundedRect(QRectF(QPointF(r.left, r.barTop), QPointF(r.right, r.barBottom)), 3, 3);
    if (m_computedLast > m_computedFirst) {
        QColor colour = tints().accent;
        colour.setAlphaF(m_stale ? 0.45F : 1.0F);
        painter.setBrush(m_stale ? QBrush(colour, Qt::BDiagPattern) : QBrush(colour));
        painter.drawRoundedRect(QRectF(QPointF(toX(m_computedFirst), r.barTop), QPointF(toX(m_computedLast), r.barBottom)), 3, 3);
    }
    painter.setBrush(Qt::NoBrush);
}

void Timeline::setBookmarks(std::vector<TimeMark> bookmarks) {
    const bool before = eventless();
    m_bookmarks = std::move(bookmarks);
    if (before != eventless()) {
        updateGeometry();
        groupSigns();
    }
    update();
}

void Timeline::setCameraKeys(std::vector<double> times) {
    const bool before = eventless();
    m_cameraKeys = std::move(times);
    if (before != eventless()) {
        updateGeometry();
        groupSigns();
    }
    update();
}

void Timeline::setPhotographs(std::vector<PhotographTime> photographs) {
    const bool before = eventless();
    m_photographs = std::move(photographs);
    if (before != eventless()) {
        updateGeometry();
        groupSigns();
    }
    update();
}

std::optional<std::size_t> Timeline::photographAt(const QPointF& point) const {
    for (std::size_t i = m_photographs.size(); i-- > 0;) {
        if (std::abs(point.x() - toX(m_photographs[i].time)) <= 7.0 &&
            std::abs(point.y() - rows().bookmarks) <= bookmarkRow / 2.0) {
            return i;
        }
    }
    return std::nullopt;
}

void Timeline::paintPhotographs(QPainter& painter, const Rows& r) const {
    for (const PhotographTime& mark : m_photographs) {
        if (mark.time < m_first || mark.time > m_last) {
            continue;
        }
        const QPointF at(toX(mark.time), r.bookmarks);
        painter.setPen(QPen(tints().muted, 1.2));
        // How long the time may be off, as a line with ends.
        const double from = toX(std::max(m_first, mark.time - mark.uncertainty));
        const double to = toX(std::min(m_last, mark.time + mark.uncertainty));
        if (to - from > 14.0) {
            painter.drawLine(QPointF(from, at.y()), QPointF(to, at.y()));
            painter.drawLine(QPointF(from, at.y() - 3), QPointF(from, at.y() + 3));
            painter.drawLine(QPointF(to, at.y() - 3), QPointF(to, at.y() + 3));
        }
        painter.setPen(QPen(tints().text, 1.2));
        painter.setBrush(palette().color(QPalette::Window));
        painter.drawRect(QRectF(at.x() - 6.0, at.y() - 4.5, 12.0, 9.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(at, 2.2, 2.2);
    }
}

void Timeline::paintCameraKeys(QPainter& painter, const Rows& r) const {
    painter.setPen(QPen(tints().text, 1.2));
    painter.setBrush(palette().color(QPalette::Window));
    for (const double time : m_cameraKeys) {
        if (time >= m_first && time <= m_last) {
            const QPointF at(toX(time), r.bookmarks);
            painter.drawPolygon(QPolygonF({at + QPointF(0, -5), at + QPointF(5, 0), at + QPointF(0, 5), at + QPointF(-5, 0)}));
        }
    }
    painter.setBrush(Qt::NoBrush);
}

void Timeline::setLoop(const std::optional<std::pair<double, double>>& range) {
    m_loop = range;
    update();
}

void Timeline::setTimeOrigin(double origin) {
    m_origin = origin;
    update();
}

QString Timeline::shownTime(double time) const {
    return figures::timeText(time - m_origin);
}

QPointF Timeline::flagOf(std::size_t bookmark) const {
    return {toX(m_bookmarks[bookmark].time), rows().bookmarks};
}

std::optional<std::size_t> Timeline::bookmarkAt(const QPointF& point) const {
    // The later one lies on top.
    for (std::size_t i = m_bookmarks.size(); i-- > 0;) {
        const QPointF flag = flagOf(i);
        if (point.x() >= flag.x() - 5.0 && point.x() <= flag.x() + 9.0 && std::abs(point.y() - flag.y()) <= bookmarkRow / 2.0) {
            return i;
        }
    }
    return std::nullopt;
}

void Timeline::paintBookmarks(QPainter& painter, const Rows& r) const {
    if (eventless()) {
        return;
    }
    painter.setPen(tints().muted);
    painter.drawText(QPointF(12, r.bookmarks + painter.fontMetrics().ascent() / 2.0 - 1.0),
                     mixed() ? tr("events") : tr("bookmarks"));
    paintPhotographs(painter, r);
    paintCameraKeys(painter, r);
    for (std::size_t i = 0; i < m_bookmarks.size(); ++i) {
        const QPointF at = flagOf(i);
        painter.setPen(QPen(tints().accent, 1.2));
        painter.setBrush(tints().accent);
        painter.drawLine(at + QPointF(0, -6), at + QPointF(0, 7));
        painter.drawPolygon(QPolygonF({at + QPointF(0, -6), at + QPointF(8, -3), at + QPointF(0, 0)}));
        painter.setBrush(Qt::NoBrush);
        // The note stands beside its flag as far as the next one leaves room.
        const double room = (i + 1 < m_bookmarks.size() ? toX(m_bookmarks[i + 1].time) : r.right) - at.x() - 18.0;
        if (room > 24.0 && !m_bookmarks[i].note.isEmpty()) {
            painter.setPen(tints().muted);
            const QString note =
                painter.fontMetrics().elidedText(m_bookmarks[i].note.simplified(), Qt::ElideRight, static_cast<int>(room));
            painter.drawText(QPointF(at.x() + 12.0, at.y() + painter.fontMetrics().ascent() / 2.0 - 1.0), note);
        }
    }
}

void Timeline::paintLoop(QPainter& painter, const Rows& r) const {
    if (!m_loop || m_loop->second <= m_first || m_loop->first >= m_last) {
        return;
    }
    const double from = toX(std::max(m_loop->first, m_first));
    const double to = toX(std::min(m_loop->second, m_last));
    QColor wash = tints().accent;
    wash.setAlphaF(0.12F);
    painter.fillRect(QRectF(QPointF(from, 4), QPointF(to, r.axis)), wash);
    // Brackets, so that the ends are seen without colour too.
    painter.setPen(QPen(tints().accent, 1.4));
    for (const auto& [x, inwards] : {std::pair(from, 4.0), std::pair(to, -4.0)}) {
        painter.drawPolyline(QPolygonF({{x + inwards, 4}, {x, 4}, {x, r.axis}, {x + inwards, r.axis}}));
    }
}

void Timeline::paintMarks(QPainter& painter, const Rows& r) const {
    const bool goesOn = m_feEnd > m_first && m_feEnd < m_last;
    if (goesOn) {
        painter.setPen(QPen(tints().muted, 1, Qt::DashLine));
        painter.drawLine(QPointF(toX(m_feEnd), r.deathsTop - 6), QPointF(toX(m_feEnd), r.axis));
    }
    const double x = toX(m_time);
    painter.setPen(QPen(tints().text, 1.6));
    painter.drawLine(QPointF(x, 6), QPointF(x, r.axis));
    painter.setBrush(tints().text);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(QPointF(x, 6), 4, 4);
    painter.setBrush(Qt::NoBrush);
    if (goesOn) {
        paintCaption(painter, r, toX(m_feEnd), 5.0, tr("FE ends"));
    }
    paintPeak(painter, r);
}

}  // namespace rubble::widgets
