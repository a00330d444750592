#pragma once

#include <QDialog>
#include <functional>
#include <optional>
#include <vector>

#include "core/evidence/surveys/pair_fit.h"
#include "widgets/evidence/surveys/survey_plan.h"
#include "widgets/render/basics/view.h"
#include "widgets/render/scene.h"

class QLabel;
class QLayout;
class QPushButton;
class QTableWidget;

namespace rubble::widgets {

class ModelMarks;
class Notice;
class NumberField;
class PhotoView;
class ViewWidget;

/// A survey from above beside the model: places that both show are clicked in turn, and what is left of each pair stands beside it
/// from the third on. Nothing changes before it is accepted.
class PlacePairsDialog : public QDialog {
    Q_OBJECT

public:
    /// @param heights  as their coordinates say, m, local; @param name  of the survey
    /// @param around   m, local, of the structure: what the error holds for
    PlacePairsDialog(SurveyHeights heights, const QString& name, const Aabb& around, QWidget* parent = nullptr);

    void setModel(const render::SceneData& scene, render::View view);
    /// A click in the survey, px of its plan, or in the model, m.
    void placeSurveyed(const QPointF& pixel);
    void placeModel(const Vec3& place);
    /// Takes back the last click or change.
    void undo();
    void clear();
    /// Drops what waits for its counterpart. @return  something did
    bool dropPending();
    /// As they are fitted: each with the accuracy that is stated of its place in the case.
    std::vector<PlacePair> pairs() const;
    /// How accurate the places of the case are, m, standard deviation along each axis; unset: not known.
    NumberField& deviation() { return *m_deviation; }
    /// What the pairs give; unset: nothing yet.
    const std::optional<PairFit>& fit() const { return m_fit; }
    /// What is done with pairs that are to be kept as a table; it may throw, which the dialog tells. Without it nothing offers to.
    void setKeeper(std::function<QString(const std::vector<PlacePair>&)> keep);
    PhotoView& survey() { return *m_survey; }
    ViewWidget& model() { return *m_model; }

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    /// What undo goes back to.
    struct Picked {
        std::vector<PlacePair> pairs;
        std::optional<Vec3> surveyed;  ///< waits for its counterpart
        std::optional<Vec3> placed;
        friend bool operator==(const Picked&, const Picked&) = default;
    };
    QWidget* buildViews();
    QWidget* buildTable();
    QLayout* buildDeviation();
    void take(Picked now);
    void removeChosen();
    void leave();
    void keep();
    void showPairs();
    void showTable();
    void showMarks();
    QString hint() const;
    bool bad(std::size_t pair) const;

    SurveyPlan m_plan;
    QString m_name;
    QImage m_picture;
    Aabb m_around;
    Picked m_now;
    std::vector<Picked> m_past;
    std::optional<PairFit> m_fit;
    QString m_problem;  ///< why there is no fit yet
    QString m_said;     ///< of the last click
    QLabel* m_hint;
    PhotoView* m_survey;
    ViewWidget* m_model;
    ModelMarks* m_marks;
    QTableWidget* m_table;
    QLabel* m_sum;
    NumberField* m_deviation;
    Notice* m_notice;
    QPushButton* m_undo;
    QPushButton* m_remove;
    QPushButton* m_clear;
    QPushButton* m_keep;
    std::function<QString(const std::vector<PlacePair>&)> m_keeper;  ///< gives what it says of it
    QPushButton* m_place = nullptr;
};

}  // namespace rubble::widgets
