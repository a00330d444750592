#include "widgets/case/run_verdict.h"

#include <QCoreApplication>

#include "widgets/basics/wording.h"
#include "widgets/figures/number_text.h"

namespace rubble::widgets {

QString gradeWords(HealthGrade grade) {
    switch (grade) {
        case HealthGrade::Notice:
            return QCoreApplication::translate("HealthGrade", "notice");
        case HealthGrade::Finding:
            return QCoreApplication::translate("HealthGrade", "finding");
        case HealthGrade::Tainted:
            break;
    }
    return QCoreApplication::translate("HealthGrade", "tainted");
}

namespace {

QString verdictOfHealth(const RunEntry& run) {
    const QString passed = limitsPassed(run.breaches);
    return run.tainted()      ? QCoreApplication::translate("RunVerdict", "tainted: %1").arg(passed)
           : run.acknowledged ? QCoreApplication::translate("RunVerdict", "%1, acknowledged").arg(passed)
           : run.grade        ? QStringLiteral("%1: %2").arg(gradeWords(*run.grade), passed)
                              : passed;
}

}  // namespace

QString limitsPassed(std::int64_t count) {
    return count == 1 ? QCoreApplication::translate("RunVerdict", "1 limit passed")
                      : QCoreApplication::translate("RunVerdict", "%1 limits passed").arg(shownCount(count));
}

QString runVerdict(const RunEntry& run) {
    if (run.complete) {
        return run.breaches == 0 ? QCoreApplication::translate("RunVerdict", "no limit passed") : verdictOfHealth(run);
    }
    const QString stopped = (run.interrupted ? QCoreApplication::translate("RunVerdict", "interrupted at %1")
                                             : QCoreApplication::translate("RunVerdict", "cancelled at %1"))
                                .arg(figures::timeText(run.endTime));
    return run.breaches == 0 ? stopped : stopped + QStringLiteral(" · ") + verdictOfHealth(run);
}

}  // namespace rubble::widgets
