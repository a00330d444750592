#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "app/gui/session/worker.h"
#include "core/base/finding.h"
#include "core/base/geometry.h"
#include "core/fe/frame.h"
#include "core/scenario/case.h"

namespace rubble {

class Computation;
class Document;
class Session;

/// Which surveys of the open case lie elsewhere than its structure: looked at in the background as soon as one is added, placed, or
/// the case is tied to the world otherwise.
class SurveyReach : public QObject {
    Q_OBJECT

public:
    explicit SurveyReach(Session& session);

    /// What speaks against the place of a survey; empty: nothing does, or it is not known yet.
    Findings of(const CaseInput& survey) const;
    bool busy() const { return m_worker.busy(); }

signals:
    /// More is known.
    void changed();

private:
    /// All that the answer depends on.
    struct Asked {
        std::string path;
        std::string sha256;
        std::optional<Registration> placed;
        Frame frame;
        Site site;
        Vec3 low;  ///< m, local, of the structure at rest
        Vec3 high;
        bool operator==(const Asked&) const = default;
    };
    struct Known {
        Asked asked;
        Findings findings;
    };
    void look();
    Asked askedOf(const CaseInput& survey) const;

    Document& m_document;
    Computation& m_computation;
    std::vector<Known> m_known;
    std::vector<Asked> m_asking;
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
