#include "app/gui/evidence/surveys/survey_pairs.h"

#include <QFileInfo>
#include <utility>

#include "app/gui/session/save_path.h"
#include "app/gui/session/session.h"
#include "core/base/error.h"
#include "io/case/terrain_reader.h"
#include "io/site/point_pairs.h"
#include "widgets/evidence/evidence_page.h"
#include "widgets/evidence/surveys/place_pairs_dialog.h"
#include "widgets/views/view_widget.h"

namespace rubble {

SurveyPairs::SurveyPairs(Session& session, widgets::EvidencePage& page, Placed placed, QObject* parent)
    : SurveyPlacing(session, page, parent), m_placed(std::move(placed)) {}

void SurveyPairs::pick(const CaseInput& survey) {
    const Inputs& inputs = m_computation.inputs();
    if (inputs.fe == nullptr) {
        m_session.tell(tr("Places are picked in the model: open the FE result first."));
        return;
    }
    readToPlace(
        survey, std::nullopt,
        [](const io::SurveyInput& read, const std::string& path) {
            if (read.survey.heights.aboveGround) {
                throw UsageError({"pairs.above_ground", "{0} holds heights above the ground, which belong to no place", {path}},
                                 {"pairs.above_ground.remedy", "Give the heights as they were surveyed.", {}});
            }
        },
        [this, id = survey.id](io::SurveyInput& read) { ask(id, read); });
}

void SurveyPairs::ask(const std::string& id, io::SurveyInput& read) {
    const Inputs& inputs = m_computation.inputs();
    if (inputs.fe == nullptr) {
        return;
    }
    widgets::PlacePairsDialog dialog(std::move(read.survey.heights), QString::fromStdString(read.survey.name),
                                     io::boundsAtRest(inputs.fe->mesh()), m_page.window());
    dialog.resize(m_page.window()->size() * 0.92);
    dialog.setModel(m_page.model().data(), m_page.model().view());
    dialog.setKeeper([&](const std::vector<PlacePair>& pairs) {
        const QString path = askSavePath(&dialog, tr("Keep pairs as a table"), m_document.base(), tr("Tables of pairs (*.csv)"));
        if (path.isEmpty()) {
            return QString();
        }
        io::writePlacePairs(path.toStdString(), pairs, inputs.frame, m_document.theCase().site);
        return tr("%1 pairs kept in %2").arg(pairs.size()).arg(QFileInfo(path).fileName());
    });
    if (dialog.exec() == QDialog::Accepted && dialog.fit()) {
        m_placed(id, *dialog.fit());
    }
}

}  // namespace rubble
