#include "widgets/basics/notice_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include "widgets/basics/icons.h"
#include "widgets/basics/theme.h"

namespace rubble::widgets {

NoticeBar::NoticeBar(QWidget* parent) : QFrame(parent), m_sign(new QLabel), m_words(new QLabel), m_row(new QHBoxLayout(this)) {
    setObjectName(QStringLiteral("noticeBar"));
    setAttribute(Qt::WA_StyledBackground);
    m_row->setContentsMargins(12, 6, 12, 6);
    m_row->setSpacing(8);
    m_words->setWordWrap(true);
    m_words->setTextFormat(Qt::RichText);
    m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_row->addWidget(m_sign);
    m_row->addWidget(m_words, 1);
}

void NoticeBar::setContent(const QString& what, const QString& more, const std::vector<Choice>& choices, bool sign) {
    m_what = what;
    m_more = more;
    m_warns = sign;
    showSign();
    for (QWidget* button : m_buttons) {
        button->hide();
        button->deleteLater();
    }
    m_buttons.clear();
    for (const Choice& choice : choices) {
        auto* button = new QPushButton(choice.text);
        button->setToolTip(choice.tip);
        button->setObjectName(choice.primary ? QStringLiteral("primary") : choice.id);
        button->setAccessibleDescription(what);
        connect(button, &QPushButton::clicked, this, [this, id = choice.id] { emit chosen(id); });
        m_row->addWidget(button);
        m_buttons.push_back(button);
    }
}

void NoticeBar::showSign() {
    QPixmap picture(QSize(18, 18) * devicePixelRatioF());
    picture.setDevicePixelRatio(devicePixelRatioF());
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setPen(tints().finding);
    drawGlyph(painter, Glyph::Finding, QRect(0, 0, 18, 18));
    m_sign->setPixmap(picture);
    m_sign->setVisible(m_warns);
    m_words->setText(m_what.toHtmlEscaped() +
                     (m_more.isEmpty()
                          ? QString()
                          : QStringLiteral(" <span style='color:%1'>%2</span>").arg(tints().muted.name(), m_more.toHtmlEscaped())));
}

void NoticeBar::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && !m_what.isEmpty()) {
        showSign();
    }
}

QString NoticeBar::text() const {
    return m_what + (m_more.isEmpty() ? QString() : u' ' + m_more);
}

}  // namespace rubble::widgets
