#include "widgets/figures/report/pdf_tags.h"

#include <QColor>
#include <QPainter>
#include <QRectF>

namespace rubble::figures {

PdfTags::PdfTags() : m_elements{{"Document", {}, {}, 0, {}, {}}} {}

void PdfTags::open(const char* type, const QString& alternative, const QString& actual) {
    m_elements[m_open].children.push_back(m_elements.size());
    m_elements.push_back({type, alternative, actual, m_open, {}, {}});
    m_open = m_elements.size() - 1;
}

void PdfTags::close() {
    m_open = m_elements[m_open].parent;
}

void PdfTags::begin(QPainter& painter) {
    m_elements[m_open].marks.push_back(++m_marks);
    paint(painter);
}

void PdfTags::end(QPainter& painter) {
    paint(painter);
}

void PdfTags::paint(QPainter& painter) {
    painter.fillRect(QRectF(markPlace, markPlace, markSize, markSize), QColor::fromRgb(++m_painted));
}

}  // namespace rubble::figures
