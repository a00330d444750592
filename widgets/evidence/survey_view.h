#pragma once

#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>

#include "core/evidence/site_section.h"
#include "core/evidence/surveys/survey_comparison.h"
#include "widgets/figures/survey_picture.h"

namespace rubble::widgets {

/// The difference map of a survey, as large as there is room, in the colours of the theme. What is compared, what was removed and
/// the line of a section can be drawn on it: clicks set corners, a double click or Enter closes, Backspace takes one back, Escape
/// gives up; the second click ends a line. The arrow keys move a cross by which Space sets a corner.
class SurveyView : public QWidget {
    Q_OBJECT

public:
    enum class Draws { Area, LeftOut, Removed, Section };

    explicit SurveyView(QWidget* parent = nullptr);
    /// @param comparison  null: says what would be here
    void setComparison(std::shared_ptr<const SurveyComparison> comparison);
    /// What is compared, as it is now in the case.
    void setScope(const SurveyScope& scope);
    /// Places whose debris was removed, and the line of the section that is shown, as they are now.
    void setMarked(const Outline& removed, const std::optional<SectionLine>& section);
    /// Begins to draw something, or ends it. Without a comparison there is nothing to draw on.
    void draw(std::optional<Draws> what);
    std::optional<Draws> drawing() const { return m_drawing; }
    /// Where a place of the site is seen; @param place  m, local
    QPointF toWidget(const Eigen::Vector2d& place) const;

signals:
    /// @param ring  corners in m, local; three or more, of a section both ends
    void drawn(rubble::widgets::SurveyView::Draws what, const rubble::OutlineRing& ring);
    /// Nothing is drawn any more.
    void left();

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    void drawPicture();
    void paintMarked(QPainter& painter) const;
    void paintDrawing(QPainter& painter) const;
    QString drawingHint() const;
    void addCorner(const QPointF& at);
    void close();

    std::shared_ptr<const SurveyComparison> m_comparison;
    SurveyScope m_scope;
    Outline m_removed;
    std::optional<SectionLine> m_section;
    QImage m_picture;
    figures::SurveyField m_field;  // px of the widget
    std::optional<Draws> m_drawing;
    OutlineRing m_corners;
    QPointF m_cross;
};

}  // namespace rubble::widgets
