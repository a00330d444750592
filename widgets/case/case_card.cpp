#include "widgets/case/case_card.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QTextLayout>

#include "widgets/basics/icons.h"
#include "widgets/basics/theme.h"

namespace rubble::widgets {

namespace {

constexpr QSize tallPicture(220, 124);
constexpr QSize widePicture(72, 44);
constexpr int padding = 8;

QFont nameFont() {
    QFont font = textFont();
    font.setWeight(QFont::DemiBold);
    return font;
}

/// Words on so many lines at most, the last one elided. @return how many lines they took
int drawWrapped(QPainter& painter, const QRect& at, const QString& words, int linesMax) {
    const QFontMetrics metrics = painter.fontMetrics();
    QTextLayout layout(words, painter.font());
    layout.beginLayout();
    int line = 0;
    for (; line < linesMax; ++line) {
        QTextLine next = layout.createLine();
        if (!next.isValid()) {
            break;
        }
        next.setLineWidth(at.width());
        const QPoint start(at.left(), at.top() + line * metrics.lineSpacing() + metrics.ascent());
        const bool last = line + 1 == linesMax;
        const QString text = last ? metrics.elidedText(words.mid(next.textStart()), Qt::ElideRight, at.width())
                                  : words.mid(next.textStart(), next.textLength());
        painter.drawText(start, text.trimmed());
    }
    layout.endLayout();
    return line;
}

}  // namespace

CaseCard::CaseCard(Form form, const Content& content, QWidget* parent) : QAbstractButton(parent), m_form(form), m_content(content) {
    setText(content.name);
    setAccessibleName(content.missing ? tr("%1, missing").arg(content.name) : content.name);
    setAccessibleDescription(content.words);
    setToolTip(content.words);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(content.missing ? Qt::ArrowCursor : Qt::PointingHandCursor);
    setEnabled(!content.missing);
    setSizePolicy(form == Form::Wide ? QSizePolicy::Expanding : QSizePolicy::Fixed, QSizePolicy::Fixed);
}

QSize CaseCard::sizeHint() const {
    const int text = QFontMetrics(textFont()).lineSpacing();
    const int small = QFontMetrics(headingFont()).lineSpacing();
    return m_form == Form::Tall ? QSize(tallPicture.width(), tallPicture.height() + 3 * padding + 2 * text + 3 * small)
                                : QSize(420, std::max(widePicture.height(), text + small) + 2 * padding);
}

QSize CaseCard::minimumSizeHint() const {
    return m_form == Form::Tall ? sizeHint() : QSize(200, sizeHint().height());
}

QRect CaseCard::pictureRect() const {
    return m_form == Form::Tall ? QRect(QPoint(0, 0), QSize(width(), tallPicture.height()))
                                : QRect(QPoint(padding, padding), QSize(widePicture.width(), height() - 2 * padding));
}

void CaseCard::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool lively = isEnabled() && (underMouse() || hasFocus());
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(QPen(hasFocus()                    ? tints().accent
                        : underMouse() && isEnabled() ? tints().muted
                                                      : tints().hairline,
                        hasFocus() ? 1.5 : 1.0));
    painter.setBrush(lively ? tints().field : tints().panel);
    painter.drawRoundedRect(frame, 5, 5);
    paintPicture(painter, pictureRect());
    paintWords(painter, m_form == Form::Tall
                            ? QRect(padding, tallPicture.height() + padding, width() - 2 * padding, height() - tallPicture.height())
                            : QRect(widePicture.width() + 3 * padding, padding, width() - widePicture.width() - 4 * padding,
                                    height() - 2 * padding));
}

void CaseCard::paintPicture(QPainter& painter, const QRect& at) const {
    QPainterPath outline;
    outline.addRoundedRect(QRectF(at).adjusted(1, 1, -1, m_form == Form::Tall ? 5 : -1), 4, 4);
    painter.save();
    painter.setClipPath(outline);
    painter.setClipRect(at, Qt::IntersectClip);
    painter.fillRect(at, tints().window);
    if (!m_content.picture.isNull()) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.setOpacity(isEnabled() ? 1.0 : 0.35);
        const QSizeF size = QSizeF(m_content.picture.size()).scaled(at.size(), Qt::KeepAspectRatioByExpanding);
        QRectF target(QPointF(0, 0), size);
        target.moveCenter(QRectF(at).center());
        painter.drawImage(target, m_content.picture);
    } else {
        painter.setPen(tints().muted);
        QRect square(0, 0, 32, 32);
        square.moveCenter(at.center());
        drawGlyph(painter, Glyph::Fragments, square);
    }
    painter.restore();
}

void CaseCard::paintWords(QPainter& painter, const QRect& at) const {
    painter.setFont(headingFont());
    const QString aside = m_content.missing ? tr("missing") : m_content.aside;
    const int asideWidth = aside.isEmpty() ? 0 : painter.fontMetrics().horizontalAdvance(aside) + 2 * padding;
    painter.setPen(tints().muted);
    const QFontMetrics name(nameFont());
    painter.drawText(QRect(at.right() - asideWidth, at.top(), asideWidth, name.lineSpacing()), Qt::AlignRight | Qt::AlignVCenter,
                     aside);
    painter.setFont(nameFont());
    painter.setPen(isEnabled() ? tints().text : tints().muted);
    const int nameLines = drawWrapped(painter, at.adjusted(0, 0, -asideWidth, 0), m_content.name, m_form == Form::Tall ? 2 : 1);
    painter.setFont(headingFont());
    painter.setPen(tints().muted);
    const QRect below(at.left(), at.top() + nameLines * name.lineSpacing() + 2, at.width(), at.height());
    if (m_form == Form::Tall) {
        drawWrapped(painter, below, m_content.words, 3);
    } else {
        const QFontMetrics small(headingFont());
        painter.drawText(QPoint(below.left(), below.top() + small.ascent()),
                         small.elidedText(m_content.words, Qt::ElideMiddle, below.width()));
    }
}

void CaseCard::enterEvent(QEnterEvent* event) {
    QAbstractButton::enterEvent(event);
    update();
}

void CaseCard::leaveEvent(QEvent* event) {
    QAbstractButton::leaveEvent(event);
    update();
}

void CaseCard::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        click();
        return;
    }
    QAbstractButton::keyPressEvent(event);
}

}  // namespace rubble::widgets
