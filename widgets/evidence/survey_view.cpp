#include "widgets/evidence/survey_view.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>

#include "widgets/basics/theme.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/survey_picture.h"

namespace rubble::widgets {

namespace {

constexpr int sideMin = 140;  // px

}  // namespace

SurveyView::SurveyView(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Difference map of the survey"));
    setMinimumSize(sideMin, sideMin);
}

void SurveyView::setComparison(std::shared_ptr<const SurveyComparison> comparison) {
    if (comparison != m_comparison) {
        m_comparison = std::move(comparison);
        m_picture = QImage();
        update();
    }
}

void SurveyView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange || event->type() == QEvent::LanguageChange) {
        m_picture = QImage();
        update();
    }
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
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
    if (m_picture.size() != pixels) {
        figures::SurveyPictureStyle style;
        style.pixels = pixels;
        style.textPixels = devicePixelRatioF() * fontMetrics().ascent();
        style.theme = currentTheme();
        m_picture = figures::surveyPicture(*m_comparison, style);
        m_picture.setDevicePixelRatio(devicePixelRatioF());
    }
    painter.drawImage(QPoint(0, 0), m_picture);
}

}  // namespace rubble::widgets
