#pragma once

#include <QImage>
#include <QWidget>
#include <memory>

#include "core/evidence/surveys/survey_comparison.h"

namespace rubble::widgets {

/// The difference map of a survey, as large as there is room, in the colours of the theme.
class SurveyView : public QWidget {
    Q_OBJECT

public:
    explicit SurveyView(QWidget* parent = nullptr);
    /// @param comparison  null: says what would be here
    void setComparison(std::shared_ptr<const SurveyComparison> comparison);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    std::shared_ptr<const SurveyComparison> m_comparison;
    QImage m_picture;
};

}  // namespace rubble::widgets
