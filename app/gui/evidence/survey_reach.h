#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "app/gui/session/background_answers.h"
#include "core/base/finding.h"
#include "core/base/geometry.h"
#include "core/fe/frame.h"
#include "core/scenario/case.h"
#include "io/site/surveys/evidence_origin.h"

namespace rubble {

class Computation;
class Document;
class Session;

/// What is found of the surveys of the open case before anything is compared: which lie elsewhere than its structure, cannot be
/// read, hold something odd, or were made by this program. Looked at in the background as soon as one is added, placed, or the case
/// is tied to the world otherwise.
class SurveyReach : public QObject {
    Q_OBJECT

public:
    explicit SurveyReach(Session& session);

    /// What speaks against the place of a survey; empty: nothing does, or it is not known yet.
    Findings of(const CaseInput& survey) const;
    /// Why a survey cannot be read; empty: it can, or it is not known yet.
    Findings unread(const CaseInput& survey) const;
    /// What is odd in it, and whether it holds what its name says.
    Findings odd(const CaseInput& survey) const;
    /// What its file says of its making by this program; nothing as long as that is not known.
    io::EvidenceOrigin origin(const CaseInput& survey) const;
    bool busy() const { return m_found.busy(); }

signals:
    /// More is known.
    void changed();

private:
    /// All that the answer depends on.
    struct Asked {
        std::string path;
        std::string sha256;
        std::optional<Registration> placed;
        CloudRequest read;
        std::optional<SurveyKind> kind;
        Frame frame;
        Site site;
        Vec3 low;  ///< m, local, of the structure at rest
        Vec3 high;
        bool operator==(const Asked&) const = default;
    };
    struct Found {
        Findings place;
        Findings unread;
        Findings odd;
        io::EvidenceOrigin origin;
    };
    const Found* found(const CaseInput& survey) const;
    static Found lookAt(const Asked& asked, const Execution& execution);
    void look();
    Asked askedOf(const CaseInput& survey) const;

    Document& m_document;
    Computation& m_computation;
    BackgroundAnswers<Asked, Found> m_found;
};

}  // namespace rubble
