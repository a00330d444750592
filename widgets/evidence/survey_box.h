#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "core/evidence/cautions.h"
#include "core/evidence/surveys/survey_comparison.h"
#include "core/scenario/removal.h"
#include "widgets/evidence/survey_place.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;
class QTableWidget;
class QToolButton;

namespace rubble::widgets {

class FindingList;
class Notice;
class NumberField;
class PointBox;
class ReadingBox;
class RemovalBox;

/// Surveys of the real debris: which of them, how it is held against the simulated debris, and what comes of it.
class SurveyBox : public QWidget {
    Q_OBJECT

public:
    explicit SurveyBox(QWidget* parent = nullptr);

    /// Standard deviations as stated, m; unset: nobody stated them.
    struct Errors {
        std::optional<double> noise;
        std::optional<double> groundNoise;
        std::optional<double> offset;  ///< that all heights may have together
    };

    struct Content {
        bool available = false;  ///< a case is open
        QStringList names;       ///< of all surveys
        int chosen = -1;
        bool cloud = false;               ///< the chosen survey is a point cloud
        bool cutsAlong = false;           ///< a section can go along it without a map: it is measured points, and there is a run
        std::optional<bool> showsFallen;  ///< whether the chosen survey shows live structure that fell; unset: not known
        SurveyScope scope;                ///< what of the chosen survey is compared
        Errors errors;
        SurveyPlace::Stated stated;
        std::vector<Removal> removals;  ///< of the case
        QString noComparison;           ///< why none can be made; empty: it can
        QString complaint;              ///< what went wrong with the last one
        bool comparing = false;
        bool stale = false;  ///< the comparison is of another run or of other settings
        Findings findings;
        std::vector<Caution> cautions;  ///< of the run that was compared
        std::shared_ptr<const SurveyComparison> comparison;
    };
    void setContent(const Content& content);
    const Content& content() const { return m_content; }
    /// What the fields ask for.
    SurveySettings settings() const;
    void setSettings(const SurveySettings& settings);
    SurveyPlace& place() { return *m_place; }
    PointBox& points() { return *m_points; }
    ReadingBox& reading() { return *m_reading; }
    RemovalBox& removals() { return *m_removals; }

signals:
    void addRequested();
    void removeRequested();
    void chosen(int survey);
    void compareRequested();
    void cancelRequested();
    void settingsChanged();
    void showsFallenChosen(std::optional<bool> shows);
    /// A polygon is to be drawn on the difference map, or taken from files.
    void scopeDrawRequested(rubble::ScopePart part);
    void scopeFileRequested(rubble::ScopePart part);
    /// @param polygon  its number within the part
    void scopeRemoved(rubble::ScopePart part, int polygon);
    void noiseChosen(const Errors& errors);
    void saveRequested();
    /// A line is to be drawn on the difference map.
    void sectionRequested();

private:
    void buildFields();
    void buildScope();
    void showScope();
    QStringList wordsOf(const SurveyComparison& made) const;
    void buildResults();
    void showResults();

    Content m_content;
    bool m_showing = false;
    QComboBox* m_surveys;
    QPushButton* m_add;
    QPushButton* m_remove;
    NumberField* m_cell;
    NumberField* m_least;
    SurveyPlace* m_place;
    ReadingBox* m_reading;
    PointBox* m_points;
    RemovalBox* m_removals;
    QComboBox* m_fit;
    QComboBox* m_showsFallen;
    QCheckBox* m_withFallen;
    NumberField* m_noise;
    NumberField* m_groundNoise;
    NumberField* m_offsetError;
    QListWidget* m_scope;
    QToolButton* m_addScope;
    QToolButton* m_removeScope;
    QPushButton* m_compare;
    QPushButton* m_cancel;
    QPushButton* m_save;
    QPushButton* m_section;
    QLabel* m_whyNot;
    Notice* m_notice;
    FindingList* m_noEvidence;  ///< that the chosen survey is none
    FindingList* m_findings;
    QTableWidget* m_figures;
    QTableWidget* m_runOut;
    QLabel* m_words;
};

}  // namespace rubble::widgets
