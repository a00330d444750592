#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/evidence/surveys/pair_fit.h"
#include "widgets/evidence/surveys/picked_places_dialog.h"
#include "widgets/evidence/surveys/survey_plan.h"

class QLabel;
class QLayout;
class QPushButton;

namespace rubble::widgets {

class Notice;
class NumberField;
class PhotoView;

/// A survey from above beside the model: places that both show are clicked in turn, and what is left of each pair stands beside it
/// from the third on. Nothing changes before it is accepted.
class PlacePairsDialog : public PickedPlacesDialog {
    Q_OBJECT

public:
    /// @param heights  as their coordinates say, m, local; @param name  of the survey
    /// @param around   m, local, of the structure: what the error holds for
    PlacePairsDialog(SurveyHeights heights, const QString& name, const Aabb& around, QWidget* parent = nullptr);

    /// A click in the survey, px of its plan, or in the model, m.
    void placeSurveyed(const QPointF& pixel);
    void placeModel(const Vec3& place);
    void undo() override;
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

protected:
    void placePicked(const Vec3& place) override { placeModel(place); }
    void removeChosen() override;
    void removeAll() override { clear(); }
    void leave() override;
    void showMarks() override;

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
    void keep();
    void showPairs();
    void showTable();
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
    PhotoView* m_survey;
    QLabel* m_sum;
    NumberField* m_deviation;
    Notice* m_notice;
    QPushButton* m_keep;
    std::function<QString(const std::vector<PlacePair>&)> m_keeper;  ///< gives what it says of it
    QPushButton* m_place = nullptr;
};

}  // namespace rubble::widgets
