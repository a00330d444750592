#include "app/gui/evidence/pairs_table.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QStringList>

#include "app/gui/session/session.h"
#include "io/case/case_surveys.h"
#include "io/site/point_pairs.h"
#include "io/site/site_place.h"
#include "io/site/surveys/named_points.h"
#include "widgets/basics/wording.h"

namespace rubble {

std::size_t addPairsOfTable(QWidget* window, const QString& path, Session& session, std::vector<PointPair>& pairs) {
    std::vector<PointPair> read;
    if (!io::needsNamedPoints(path.toStdString())) {
        read = io::readPointPairs(path.toStdString());
    } else {
        Findings findings;
        const Case& theCase = session.document().theCase();
        const io::SitePlace place(session.computation().inputs().frame, theCase.site);
        std::vector<io::NamedPoint> measured =
            io::controlPointsOfCase(theCase, session.document().base().toStdString(), place, findings, Execution());
        if (measured.empty()) {
            const QString points = QFileDialog::getOpenFileName(
                window, QCoreApplication::translate("PairsTable", "Measured points that the pairs name"),
                QFileInfo(path).absolutePath(),
                QCoreApplication::translate("PairsTable", "Points of a total station (*.csv *.txt *.dxf);;All files (*)"));
            if (points.isEmpty()) {
                return 0;
            }
            measured = io::readNamedPoints(points.toStdString(), findings, Execution());
        }
        read = io::readPointPairs(path.toStdString(), measured, [&place](const Vec3& at) { return place.toLocal(at); });
        QStringList words;
        for (const Finding& finding : findings.list()) {
            words << widgets::worded(finding.what);
        }
        session.tell(widgets::inOneLine(words));
    }
    pairs.insert(pairs.end(), read.begin(), read.end());
    return read.size();
}

}  // namespace rubble
