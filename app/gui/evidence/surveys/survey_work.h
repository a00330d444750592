#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <string>

#include "app/gui/evidence/evidence_work.h"
#include "app/gui/session/worker.h"
#include "app/gui/studies/answer.h"
#include "core/evidence/surveys/survey_comparison.h"
#include "core/scenario/case.h"
#include "io/run/run_file.h"
#include "io/site/survey_file.h"

namespace rubble {

class Session;

/// The comparison with a survey, whoever shows it.
class SurveyWork : public QObject {
    Q_OBJECT

public:
    /// What a survey is held against, and how.
    struct Compared {
        CaseInput survey;
        const void* run = nullptr;
        SurveySettings settings;
        io::RunOrigin origin = {};  ///< of the run
        Findings said = {};         ///< of what the case says of the survey
        /// What can be chosen is the same.
        bool operator==(const Compared& other) const;
    };
    struct Made {
        SurveyComparison comparison;
        io::SurveyInput input;  ///< what was compared with
    };

    explicit SurveyWork(Session& session);

    /// Compares a run with a survey; answers with changed(). @param path  of the survey
    void start(const Compared& order, const EvidenceRun& run, const Case& theCase, const Frame& frame, const std::string& path);
    void cancel();

    int chosen = 0;
    Answer<Compared, Made> answer;
    bool shown = false;  ///< its map stood in the centre then

signals:
    void changed();
    /// There is another comparison.
    void compared();

private:
    void take(const std::shared_ptr<Made>& made, const std::exception_ptr& thrown);

    std::shared_ptr<Made> m_making;  // null: what is made is not awaited any more
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
