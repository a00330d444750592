#pragma once

#include <QDialog>
#include <optional>
#include <string>

#include "core/base/finding.h"
#include "core/base/outline.h"
#include "core/evidence/clouds/cloud_fit.h"
#include "widgets/evidence/surveys/survey_plan.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace rubble::widgets {

class FindingList;
class Notice;
class NumberField;
class PhotoView;

/// A cloud from above, on which somebody draws what did not move, and what fitting the cloud there gave. Nothing changes before it
/// is accepted.
class FitDialog : public QDialog {
    Q_OBJECT

public:
    /// A move that was found.
    struct Found {
        CloudFit fit;
        std::optional<double> error;  ///< m, standard deviation that places at the structure are then known to
        Findings findings;
    };
    struct Content {
        bool fitting = false;
        QString complaint;  ///< what went wrong with the last one
        std::optional<Found> found;
    };

    /// @param heights  of the cloud as it lies now, m, local; @param against  what it is fitted to, for people
    FitDialog(SurveyHeights heights, const QString& name, const QString& against, QWidget* parent = nullptr);

    void setContent(const Content& content);
    const Content& content() const { return m_content; }
    /// What did not move, m, local; empty: most of the cloud. Unset: nobody said it yet.
    std::optional<Outline> stable() const;
    void addAreas(const Outline& areas);
    double radius() const;
    PhotoView& plan() { return *m_view; }

signals:
    void fitRequested();
    void cancelRequested();
    /// Areas are to be taken from a file.
    void polygonsRequested();
    /// What was found is of other areas or of another radius now.
    void outdated();

private:
    void buildFields();
    void change(Outline areas);
    void showState();

    SurveyPlan m_plan;
    QString m_name;
    QImage m_picture;
    Outline m_areas;
    Content m_content;
    PhotoView* m_view;
    QCheckBox* m_everywhere;
    NumberField* m_radius;
    QPushButton* m_file;
    QPushButton* m_last;
    QPushButton* m_fit;
    QPushButton* m_cancel;
    QLabel* m_said;
    Notice* m_notice;
    FindingList* m_findings;
    QPushButton* m_place = nullptr;
};

}  // namespace rubble::widgets
