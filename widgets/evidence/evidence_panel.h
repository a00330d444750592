#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/evidence/cautions.h"
#include "core/evidence/photographs/photo_comparison.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/wording.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace rubble::widgets {

class NumberField;
class EvidenceTable;
class PhotoPairs;
class SurveyBox;

/// Photographs of the site: what their files say, when they were taken, the point pairs and the camera that these give, and how far
/// the simulated debris agrees with what is drawn. Shows what it is given; an edit leaves as a whole photograph.
class EvidencePanel : public Panel {
    Q_OBJECT

public:
    explicit EvidencePanel(QWidget* parent = nullptr);

    struct Content {
        bool available = false;  ///< a case is open
        bool withFallen = true;  ///< fallen live structure counts as debris
        QStringList names;       ///< of all photographs
        int chosen = -1;
        Photograph photograph;  ///< the chosen one
        QString unchanged;      ///< whether its file is the one that was added
        Findings findings;      ///< of its file
        std::optional<CameraMatch> match;
        QString noMatch;  ///< what keeps the camera from being found, and the remedy
        QString remedy;
        std::vector<Caution> cautions;  ///< of the match and of the run that is compared
        std::shared_ptr<const PhotoComparison> comparison;
        QString noComparison;          ///< why none can be made; empty: it can
        QString comparisonComplaint;   ///< what went wrong with the last one
        bool comparisonStale = false;  ///< of another run or of other drawings
        bool comparing = false;
        int chosenPair = -1;
        int chosenMask = -1;
    };
    void setContent(const Content& content);
    const Content& content() const { return m_content; }
    void setAdding(bool adding);
    SurveyBox& survey() { return *m_survey; }
    EvidenceTable& list() { return *m_list; }

signals:
    void addRequested();
    void removeRequested();
    void photographChosen(int index);
    /// @param what  names the edit for undo
    void photographEdited(const rubble::Photograph& after, const rubble::widgets::Wording& what);
    void pairChosen(int pair);
    void maskChosen(int mask);
    void addToggled(bool adding);
    void readPairsRequested();
    void compareRequested();
    void cancelRequested();
    /// Whether fallen structure counts as debris to photographs.
    void withFallenChosen(bool with);

private:
    void buildList();
    void buildTime();
    void buildPoints();
    void buildCamera();
    void buildMasks();
    void buildAgreement();
    void showFacts();
    void showTime();
    void showCamera();
    void showMasks();
    void showAgreement();
    void edit(const Wording& what, const std::function<void(Photograph&)>& change);

    Content m_content;
    bool m_showing = false;
    EvidenceTable* m_list;
    QComboBox* m_photographs;
    QPushButton* m_add;
    QPushButton* m_remove;
    QLabel* m_facts;
    FindingList* m_findings;
    std::vector<QWidget*> m_details;  // that belong to a photograph
    QLineEdit* m_note;
    QCheckBox* m_atRest;
    NumberField* m_time;
    NumberField* m_uncertainty;
    PhotoPairs* m_pairs;
    NumberField* m_focal;
    QComboBox* m_principal;
    QComboBox* m_radial;
    QLabel* m_place = nullptr;
    QLabel* m_placeSpread = nullptr;
    QLabel* m_turnSpread = nullptr;
    QLabel* m_focalNoted = nullptr;
    QLabel* m_focalFound = nullptr;
    QLabel* m_fit = nullptr;
    Notice* m_verdict;
    FindingList* m_doubts;
    QListWidget* m_masks;
    QPushButton* m_removeMask;
    QCheckBox* m_withFallen;
    QPushButton* m_compare;
    QPushButton* m_cancel;
    QLabel* m_whyNot;
    QLabel* m_iou = nullptr;
    QLabel* m_iouMean = nullptr;
    QLabel* m_edge = nullptr;
    QLabel* m_edgePixels = nullptr;
    QLabel* m_overTime = nullptr;
    Notice* m_agreement;
    SurveyBox* m_survey;
};

}  // namespace rubble::widgets
