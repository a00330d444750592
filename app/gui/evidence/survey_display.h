#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/gui/evidence/evidence_work.h"
#include "app/gui/session/worker.h"
#include "core/evidence/surveys/survey_comparison.h"
#include "core/scenario/case.h"
#include "io/site/survey_file.h"

namespace rubble {

class Actions;
class Computation;
class Document;
class PanelDeck;
class Session;
namespace widgets {
class EvidencePage;
}

/// The comparison with a survey, whoever shows it.
class SurveyWork : public QObject {
    Q_OBJECT

public:
    explicit SurveyWork(Session& session);

    /// Compares a run with the survey that `comparedWith` names, by `comparedSettings`; answers with changed().
    void start(const EvidenceRun& run, const Case& theCase, const Frame& frame, const std::string& path);
    void cancel();

    int chosen = 0;
    bool comparing = false;
    std::optional<Failure> complaint;
    std::shared_ptr<const SurveyComparison> comparison;  ///< null: there is none
    std::shared_ptr<const io::SurveyInput> input;        ///< what was compared with
    CaseInput comparedWith;
    SurveySettings comparedSettings;
    const void* comparedRun = nullptr;
    std::optional<SurveySettings> asked;  ///< what the fields asked for when a window went
    bool shown = false;                   ///< its map stood in the centre then

signals:
    void changed();
    /// There is another comparison.
    void compared();

private:
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

/// Brings the surveys of the case together with their box in the Evidence panel, the difference map in the centre and the run.
/// Comparing runs in the background; adding and removing a survey are undoable commands.
class SurveyDisplay : public QObject {
    Q_OBJECT

public:
    SurveyDisplay(Session& session, PanelDeck& deck, widgets::EvidencePage& page, Actions& actions, QObject* parent = nullptr);
    ~SurveyDisplay() override;

    void chooseFile();
    void add(const QString& path);
    void compare();
    void cancel();
    bool busy() const { return m_work.comparing; }
    const std::shared_ptr<const SurveyComparison>& comparison() const { return m_work.comparison; }
    /// Writes the difference map as GeoTIFF or PNG, by the ending.
    void saveTo(const QString& path);
    void refresh();

private:
    std::vector<const CaseInput*> surveys() const;
    const CaseInput* current() const;
    QString whyNot() const;
    bool stale() const;
    void remove();
    void setShowsFallen(std::optional<bool> shows);
    void save();

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    PanelDeck& m_deck;
    widgets::EvidencePage& m_page;
    SurveyWork& m_work;
};

}  // namespace rubble
