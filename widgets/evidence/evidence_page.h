#pragma once

#include <QWidget>
#include <array>
#include <memory>
#include <optional>

#include "core/base/ids.h"
#include "core/evidence/surveys/survey_comparison.h"
#include "widgets/evidence/model_marks.h"
#include "widgets/evidence/photo_view.h"

class QButtonGroup;
class QComboBox;
class QLabel;
class QSlider;
class QSplitter;
class QToolButton;

namespace rubble::widgets {

class SurveyView;
class ViewWidget;

/// A photograph with the simulation over it, and beside it the model, in which the counterpart of a point is clicked.
class EvidencePage : public QWidget {
    Q_OBJECT

public:
    explicit EvidencePage(QWidget* parent = nullptr);

    PhotoView& photo() { return *m_photo; }
    SurveyView& survey() { return *m_survey; }
    ViewWidget& model() { return *m_model; }
    /// What is marked in the model.
    ModelMarks& modelMarks() { return *m_marks; }
    /// Whether the simulation can be seen from the camera; else why not.
    void setSeen(bool seen, const QString& why);
    void setShow(PhotoView::Show show);
    void setBeside(bool beside);
    bool beside() const;
    /// Point and mask tools need a photograph.
    void setReady(bool ready);
    void setTool(PhotoView::Tool tool, MaskClass kind = MaskClass::Debris);
    /// What is to be clicked next, in words.
    void setHint(const QString& hint);
    /// The comparison with a survey that the difference map shows; null: none.
    void setSurvey(const std::shared_ptr<const SurveyComparison>& comparison);
    /// Whether the difference map stands here instead of the photograph.
    void showSurvey(bool shown);
    bool surveyShown() const;

signals:
    void showChanged(rubble::widgets::PhotoView::Show show);
    void toolChanged(rubble::widgets::PhotoView::Tool tool);
    /// A point of the model was clicked, as a place in the model's widget.
    void modelClicked(const QPointF& place);
    void besideChanged(bool beside);
    /// The model beside the photograph came into sight, or went.
    void modelSeen(bool seen);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* buildTools();
    void showHint();

    PhotoView* m_photo;
    ViewWidget* m_model;
    ModelMarks* m_marks;
    QSplitter* m_splitter;
    SurveyView* m_survey;
    QToolButton* m_surveyShown;
    QButtonGroup* m_shows;
    QToolButton* m_beside;
    QSlider* m_slider;
    QToolButton* m_point;
    QComboBox* m_mask;
    QToolButton* m_draw;
    QLabel* m_hint;
    QString m_said;
    QString m_whyNotSeen;
};

}  // namespace rubble::widgets
