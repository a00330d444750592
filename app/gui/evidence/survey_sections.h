#pragma once

#include <QObject>
#include <QStringList>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/evidence/survey_display.h"
#include "io/site/surveys/run_section.h"

namespace rubble {

namespace widgets {
class SectionDialog;
}

/// Sections that are drawn on the difference map: cuts run and survey in the background and shows the profile.
class SurveySections : public QObject {
    Q_OBJECT

public:
    /// What is cut along what.
    struct Order {
        SectionLine line;
        CaseInput survey;
        std::shared_ptr<const SurveyWork::Made> made;  ///< null: of measured points, which no map shows
        bool along = false;                            ///< the line is still to be found of the points
    };

    SurveySections(Session& session, widgets::EvidencePage& page, QObject* parent = nullptr);

    /// Cuts along a line from its first to its last corner. @param made  what stands on the map; @param survey  it is of
    void cut(const OutlineRing& ends, const CaseInput& survey, std::shared_ptr<const SurveyWork::Made> made);
    /// Cuts along measured points, which need no map: the line is found of them.
    void cutAlong(const CaseInput& points);
    /// Looks whether what was cut is of something else now. @param mapStale  the map that lines are drawn on is
    void refresh(bool mapStale);
    bool busy() const { return m_worker.busy(); }
    /// Null: none was cut.
    std::shared_ptr<const io::RunSection> section() const { return m_section; }
    /// The line that is shown; unset: none.
    std::optional<SectionLine> line() const;
    widgets::SectionDialog* dialog() const { return m_dialog; }
    void saveTo(const QString& path);

signals:
    void changed();

private:
    /// Measured points of the case that stand in the section too, by full path and with what of them counts.
    std::vector<CaseInput> measuredPoints(Findings& said) const;
    void begin(Order order);
    void cutAgain();
    void moveEnds(const std::array<Eigen::Vector2d, 2>& ends);
    void show(const QString& complaint = {});
    void save();

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    widgets::EvidencePage& m_page;
    std::optional<Order> m_order;
    std::shared_ptr<const io::RunSection> m_section;
    const RunRecord* m_cutOf = nullptr;
    bool m_stale = false;
    widgets::SectionDialog* m_dialog = nullptr;
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
