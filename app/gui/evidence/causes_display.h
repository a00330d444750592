#pragma once

#include <QObject>
#include <QStringList>
#include <memory>

#include "app/gui/studies/answer.h"
#include "app/gui/studies/study_work.h"

namespace rubble {

class CauseChoice;
class Computation;
class Document;
class Session;
class EnsembleDisplay;
namespace widgets {
class CausesPage;
class CausesPanel;
}  // namespace widgets

/// Brings supposed causes and what they are held against (CauseChoice) together with their panel and their page in the centre.
class CausesDisplay : public QObject {
    Q_OBJECT

public:
    CausesDisplay(Session& session, EnsembleDisplay& ensemble, widgets::CausesPanel& panel, widgets::CausesPage& page,
                  QObject* parent = nullptr);

    /// Cases or FE results of the same site, each for another cause.
    void addCauses(const QStringList& paths);
    void addEvidence(io::EvidenceFile::Kind kind, const QStringList& paths);
    /// Each as KIND=FILE: footprint, height, surface.
    void addEvidence(const QStringList& named);
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
    /// What outlives the window.
    struct Kept {
        Answer<Compared, MadeComparison> answer;
        QString base;  ///< of the case that is open
        std::optional<Failure> failure;
    };

    void connectPanel();
    void chooseCauses();
    void chooseEvidence(io::EvidenceFile::Kind kind);
    /// Somebody chose otherwise: it is there the next time.
    void chosen();
    void ended(const Failure* failure);
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
    CauseChoice& m_choice;
    Kept& m_kept;
    bool m_simulating = false;  // a run, as the panel was last told
    QString m_busy;
};

}  // namespace rubble
