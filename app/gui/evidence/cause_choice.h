#pragma once

#include <QObject>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "app/gui/session/worker.h"
#include "app/gui/studies/study_work.h"
#include "core/evidence/evidence_list.h"
#include "io/case/kept_causes.h"

namespace rubble {

class Document;
class Session;
class SurveyReach;

/// Which supposed causes are held against which evidence: the scenarios and the evidence of the open case, what was added to them,
/// and what of all that is ticked. It outlives windows, and lies beside the case for the next time.
class CauseChoice : public QObject {
    Q_OBJECT

public:
    explicit CauseChoice(Session& session);

    struct Cause {
        StudyCase study;  ///< under the name that the comparison gives it
        QString where;
        QString why;  ///< it cannot be used; empty: it can
        bool used = true;
        bool added = false;
    };
    struct Evidence {
        std::variant<std::string, io::EvidenceFile, TimeEvidence>
            what;           ///< the input of a photograph of the case; else as it is read
        std::string input;  ///< id of that of the case; empty: it was added
        QString name;
        QString tip;  ///< where it lies, or what it says
        QString why;  ///< it does not count; empty: it does
        bool used = true;
    };
    /// All that is offered, that of the case first.
    std::vector<Cause> causes() const;
    std::vector<Evidence> evidence() const;
    /// What is ticked and can be used.
    CauseOrder order() const;

    /// A case or an FE result of the same site; one that is known already is not added again. Throws as io::loadCase() and
    /// io::caseForFe().
    void addCause(const QString& path);
    void addFile(const io::EvidenceFile& file);
    void addTime(const TimeEvidence& time);
    /// By their places in the lists; those of the case cannot be removed.
    void useCause(std::size_t cause, bool used);
    void useEvidence(std::size_t evidence, bool used);
    void removeCause(std::size_t cause);
    void removeEvidence(std::size_t evidence);
    void setBlind(bool blind) { m_kept.blind = blind; }
    bool blind() const { return m_kept.blind; }
    /// Keeps the choice for the next time that this case is opened.
    void keep();

signals:
    /// More is known of what is offered.
    void changed();
    /// Another case is open, with a choice of its own.
    void replaced();

private:
    /// An added case, as it was read.
    struct Opened {
        StudyCase cause;
        bool plain = false;  ///< an FE result, which has no settings of its own
        std::optional<Failure> failure;
    };
    static Opened open(const std::string& path);
    /// One that was added earlier; where it cannot be opened any more it says why.
    static Opened openedAgain(const std::string& path);
    void take();
    StudyCase asOpen(const Opened& result, const std::string& path) const;
    std::vector<EvidenceRow> ownEvidence() const;
    QString whyNot(const CaseInput& survey) const;

    Session& m_session;
    Document& m_document;
    SurveyReach& m_reach;
    io::KeptCauses m_kept;
    std::map<std::string, Opened> m_opened;  ///< by path
    QString m_base;                          ///< of the case that this is about
    QString m_file;                          ///< that the choice is kept in; empty: none
};

}  // namespace rubble
