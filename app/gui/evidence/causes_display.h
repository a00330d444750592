#pragma once

#include <QObject>
#include <QStringList>
#include <memory>
#include <set>

#include "app/gui/studies/answer.h"
#include "app/gui/studies/study_work.h"

namespace rubble {

class Computation;
class Document;
class Session;
class EnsembleDisplay;
namespace widgets {
class CausesPage;
class CausesPanel;
}  // namespace widgets

/// Which causes are held against which evidence: the scenarios of the case and other cases of the site, the photographs of the case
/// and files of what was found. Brings them together with their panel and their page in the centre.
class CausesDisplay : public QObject {
    Q_OBJECT

public:
    CausesDisplay(Session& session, EnsembleDisplay& ensemble, widgets::CausesPanel& panel, widgets::CausesPage& page,
                  QObject* parent = nullptr);

    ~CausesDisplay() override;

    /// Cases or FE results of the same site, each for another cause.
    void addCauses(const QStringList& paths);
    void addEvidence(io::EvidenceFile::Kind kind, const QStringList& paths);
    /// Each as KIND=FILE: footprint, height, surface.
    void addEvidence(const QStringList& named);
    void addTime(const TimeEvidence& time);
    void compare();
    void setBusy(const QString& why);
    void refresh();
    /// Null: nothing was compared.
    const std::shared_ptr<const MadeComparison>& made() const { return m_kept.answer.result(); }
    bool stale() const;
    void saveTableTo(const QString& path);
    void saveMapTo(const QString& path);

signals:
    void saveChartRequested();

private:
    /// Causes, and how their members are made.
    struct Compared {
        CauseOrder causes;
        StudyOrder study;
        /// What decides the ranking is the same.
        bool operator==(const Compared& other) const;
    };
    struct Added {
        StudyCase cause;
        QString path;
        bool used = true;
        bool plain = false;  // an FE result, which has no settings of its own
    };
    struct File {
        io::EvidenceFile file;
        bool used = true;
    };
    struct Timed {
        TimeEvidence time;
        bool used = true;
    };
    /// What outlives the window.
    struct Kept {
        std::vector<Added> added;
        std::vector<File> files;
        std::vector<Timed> times;
        std::set<std::string> unticked;  ///< ids of own scenarios and photographs that are not used
        Answer<Compared, MadeComparison> answer;
        QString base;  ///< of the case that is open
        std::optional<Failure> failure;
        bool blind = false;  ///< what the panel was set to when a window went
    };

    void connectPanel();
    void chooseCauses();
    void chooseEvidence(io::EvidenceFile::Kind kind);
    void setCauseUsed(int cause, bool used);
    void setEvidenceUsed(int evidence, bool used);
    void ended(const Failure* failure);
    /// The scenarios of the open case that are causes, in their order.
    std::vector<StudyCase> ownCauses() const;
    /// An FE result under the settings, on the site and with the terrain of the open case.
    StudyCase asOpen(const Added& result) const;
    CauseOrder causeOrder() const;
    StudyOrder studyOrder() const;
    QString whyNot(const CauseOrder& order) const;
    void showPanel();
    void showFailure(const std::optional<Failure>& failure);
    void showPage();
    void saveTable();
    void saveMap();

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    StudyWork& m_work;
    EnsembleDisplay& m_ensemble;
    widgets::CausesPanel& m_panel;
    widgets::CausesPage& m_page;
    Kept& m_kept;
    bool m_simulating = false;  // a run, as the panel was last told
    QString m_busy;
};

}  // namespace rubble
