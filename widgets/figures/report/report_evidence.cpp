#include <QFileInfo>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/unknown.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/report/report_sections.h"
#include "widgets/figures/report/spoken_text.h"

namespace rubble::figures {
namespace {

/// What a file is to the case, in words.
QString roleShown(const std::string& role) {
    const std::array<std::pair<std::string_view, QString>, 11> names{{{"fe", ReportSections::tr("FE result")},
                                                                      {"terrain", ReportSections::tr("terrain")},
                                                                      {"photograph", ReportSections::tr("photograph")},
                                                                      {"survey", ReportSections::tr("survey")},
                                                                      {"orthophoto", ReportSections::tr("orthophoto")},
                                                                      {"surroundings", ReportSections::tr("surroundings")},
                                                                      {"run", ReportSections::tr("run")},
                                                                      {"case", ReportSections::tr("case")},
                                                                      {"causes", ReportSections::tr("comparison of causes")},
                                                                      {"cause", ReportSections::tr("of the compared causes")},
                                                                      {"words", ReportSections::tr("words of the author")}}};
    const auto found = std::find_if(names.begin(), names.end(), [&](const auto& name) { return name.first == role; });
    return found != names.end() ? found->second : escaped(role);
}

/// "+12 %": how much more the simulated is than the surveyed.
QString shareShown(double simulated, double surveyed) {
    const double share = 100.0 * (simulated - surveyed) / surveyed;
    if (!std::isfinite(share)) {
        return QStringLiteral("–");
    }
    const int whole = static_cast<int>(std::lround(share));
    const QString sign = whole < 0 ? QStringLiteral("−") : whole > 0 ? QStringLiteral("+") : QString();
    return sign + QString::number(std::abs(whole)) + QStringLiteral(" %");
}

}  // namespace

void ReportSections::addEvidence() {
    heading(tr("Evidence"));
    addFiles();
    if (m_facts.words.custody.empty()) {
        text(tr("Who held these files before this report was made, and what was done to them, is not said here."));
    } else {
        heading(tr("Custody of the material"), 2);
        ownWords(m_facts.words.custody);
        heading(tr("What was read"), 2);
    }
    const FeResult::Contents& fe = m_facts.fe->contents();
    text(tr("The FE result (%1) holds %2 elements and %3 states from %4 s to %5 s. Activity is decided by: %6. Units: %7.")
             .arg(escaped(fe.format), countText(m_facts.fe->mesh().elementCount()), countText(fe.times.size()),
                  reportSeconds(fe.times.front()), reportSeconds(fe.times.back()), spokenText(fe.activityFrom).toHtmlEscaped(),
                  unitShown(spokenText(fe.unitsFrom).toHtmlEscaped())));
    addPlace();
    addPhotographs();
    addSurveys();
}

void ReportSections::addFiles() {
    ReportTable table;
    table.caption = tr("Files that this report rests on, as they were when it was made");
    table.columns = QStringList{tr("role"), tr("file"), tr("SHA-256")};
    table.words = {true, true, true};
    table.shares = {0.12, 0.26, 0.62};
    table.small = true;
    for (const ReportFile& file : m_facts.files) {
        table.rows.push_back({roleShown(file.role), QFileInfo(QString::fromStdString(file.path)).fileName().toHtmlEscaped(),
                              QStringLiteral("<code>%1</code>").arg(QString::fromStdString(file.sha256))});
    }
    m_blocks.push_back(std::move(table));
    if (!m_facts.runKept) {
        text(tr("The run was simulated for this report and lies in no file. A repeat is the same run if its fingerprint is %1.")
                 .arg(QStringLiteral("<code>%1</code>").arg(QString::fromStdString(m_facts.fingerprint))));
    }
}

void ReportSections::addPhotographs() {
    if (m_facts.photographs.empty()) {
        text(tr("The case has no photographs; the simulated debris was not held against pictures of the site."));
        return;
    }
    heading(tr("Photographs"), 2);
    text(
        tr("The camera of a photograph is found from points that were picked on it and in the model. The silhouette of the "
           "simulated debris is then held against the outline that was drawn on the photograph; spreads are those over the cameras "
           "that the points allow."));
    ReportTable table;
    table.caption = tr("Photographs: camera match, and the silhouette of the simulated debris against the outline drawn on them");
    table.columns = QStringList{tr("photograph"), tr("points used"),       tr("RMS [px]"),        tr("camera within, 95 % [m]"),
                                tr("IoU"),        tr("spread of the IoU"), tr("edges apart [m]"), tr("spread [m]")};
    table.words = {true, false, false, false, false, false, false, false};
    table.shares = {0.2, 0.11, 0.1, 0.15, 0.09, 0.12, 0.12, 0.11};
    for (const ReportPhoto& photo : m_facts.photographs) {
        const CameraMatch* match = photo.match ? &*photo.match : nullptr;
        const PhotoComparison* made = photo.comparison ? &*photo.comparison : nullptr;
        const auto used = match != nullptr ? std::count(match->used.begin(), match->used.end(), true) : 0;
        table.rows.push_back({escaped(photo.name), tr("%1 of %2").arg(used).arg(photo.photograph.pairs.size()),
                              reportNumber(match != nullptr ? match->rms : unknown, 2),
                              reportNumber(match != nullptr ? match->placeRadius : unknown, 2),
                              reportNumber(made != nullptr ? made->iou.best : unknown),
                              reportNumber(made != nullptr ? made->iou.spread : unknown, 2),
                              reportNumber(made != nullptr ? made->edgeMetres.best : unknown),
                              reportNumber(made != nullptr ? made->edgeMetres.spread : unknown, 2)});
    }
    table.source = source();
    m_blocks.push_back(std::move(table));
    for (std::size_t i = 0; i < m_facts.photographs.size(); ++i) {
        addPhotograph(m_facts.photographs[i], i < m_pictures.photographs.size() ? m_pictures.photographs[i] : QImage());
    }
}

/// What speaks against resting a conclusion on it: beside its figures, and beside the answer that it stands behind.
void ReportSections::addEvidenceCautions(const std::string& name, const std::vector<Caution>& cautions) {
    for (const Caution& caution : cautions) {
        notice(tr("%1: %2").arg(escaped(name), said(caution.what)));
    }
}

void ReportSections::addPhotograph(const ReportPhoto& photo, const QImage& picture) {
    const QString name = escaped(photo.name);
    if (!photo.problem.empty()) {
        text(tr("%1: %2").arg(name, said(photo.problem)));
    }
    addEvidenceCautions(photo.name, photo.cautions);
    if (picture.isNull()) {
        return;
    }
    QStringList caption{name};
    if (!photo.photograph.note.empty()) {
        caption << escaped(photo.photograph.note);
    }
    if (!photo.photograph.masks.empty()) {
        caption << tr("White: the outline drawn on it; dotted, what was left out.");
    }
    if (photo.comparison) {
        caption << tr("Orange: the outline of the simulated debris at %1 s, %2.")
                       .arg(reportSeconds(photo.comparison->time), photo.comparison->withFallen
                                                                       ? tr("fallen live structure with it")
                                                                       : tr("without fallen live structure"));
    }
    ReportFigure figure;
    figure.picture = picture;
    // Sentences of their own keep their full stop.
    caption.front() += QStringLiteral(".");
    figure.caption = figure.words = caption.join(QLatin1Char(' '));
    figure.source = source();
    m_blocks.push_back(std::move(figure));
}

namespace {

/// In which cells, from which height on, and moved by what.
QString howCompared(const QString& name, const SurveyComparison& made) {
    const auto metres = [](double value) { return reportNumber(value) + QStringLiteral("\u00A0m"); };
    QString words = made.isFootprint ? ReportSections::tr("%1: cells of %2.").arg(name, metres(made.settings.cell))
                                     : ReportSections::tr("%1: cells of %2; heights count as debris from %3 above the ground on.")
                                           .arg(name, metres(made.settings.cell), metres(made.least));
    if (made.settings.fit != SurveyFit::None) {
        words +=
            u' ' + (made.settings.fit == SurveyFit::Ground
                        ? ReportSections::tr("It was brought to the ground of the run first, by %1, %2 and %3 along x, y and up.")
                        : ReportSections::tr("It was brought to the debris of the run first, by %1, %2 and %3 along x, y and up."))
                       .arg(metres(made.shift.by.x()), metres(made.shift.by.y()), metres(made.shift.by.z()));
    }
    return words;
}

}  // namespace

void ReportSections::addSurveys() {
    if (m_facts.surveys.empty()) {
        text(tr("The case has no survey of the debris; heights and outline were not held against one."));
        return;
    }
    heading(tr("Surveys"), 2);
    for (const Caution& caution : m_facts.cautions) {
        if (caution.inPictures()) {
            notice(said(caution.what));
        }
    }
    const bool moved = std::any_of(m_facts.surveys.begin(), m_facts.surveys.end(), [](const ReportSurvey& survey) {
        return survey.comparison && survey.comparison->settings.fit != SurveyFit::None;
    });
    text((moved ? tr("A survey is compared cell by cell, once it was brought to the run as is said below.")
                : tr("A survey is compared cell by cell where it was taken, without moving it.")) +
         u' ' +
         tr("Volumes lie between ground and top and hold the voids. Steep edges make a surveyed area too large: measures of both "
            "sides surveyed alike are free of that."));
    ReportTable table;
    table.caption = tr("Surveys: surveyed debris against the simulated");
    table.columns = QStringList{tr("survey"), tr("measure"), tr("unit"), tr("surveyed"), tr("simulated"), tr("compared")};
    table.words = {true, true, true, false, false, false};
    table.shares = {0.2, 0.33, 0.08, 0.13, 0.13, 0.13};
    for (const ReportSurvey& survey : m_facts.surveys) {
        if (survey.comparison) {
            addSurveyRows(table, escaped(survey.name), *survey.comparison);
        }
    }
    table.source = source();
    if (!table.rows.empty()) {
        m_blocks.push_back(std::move(table));
    }
    for (std::size_t i = 0; i < m_facts.surveys.size(); ++i) {
        const ReportSurvey& survey = m_facts.surveys[i];
        addEvidenceCautions(survey.name, survey.cautions);
        if (survey.comparison) {
            text(howCompared(escaped(survey.name), *survey.comparison));
        }
        if (survey.comparison && !survey.comparison->settings.scope.whole()) {
            const LeftOutDebris& left = survey.comparison->leftOut;
            text(tr("%1: compared inside the areas that were drawn alone, %2 m². Beyond them lie %3 m² of surveyed and %4 m² of "
                    "simulated debris, which do not count.")
                     .arg(escaped(survey.name), reportNumber(left.comparedArea), reportNumber(left.surveyedArea),
                          reportNumber(left.simulatedArea)));
        }
        if (!survey.comparison) {
            text(tr("%1: %2").arg(escaped(survey.name), said(survey.problem)));
        } else if (i < m_pictures.surveys.size() && !m_pictures.surveys[i].isNull()) {
            ReportFigure figure;
            figure.picture = m_pictures.surveys[i];
            figure.caption = figure.words = tr("%1: difference map. %2").arg(escaped(survey.name), said(survey.comparison->words));
            figure.source = source();
            m_blocks.push_back(std::move(figure));
        }
    }
}

void ReportSections::addSurveyRows(ReportTable& table, const QString& name, const SurveyComparison& made) const {
    const QString dash = QStringLiteral("–");
    const auto both = [&](const QString& measure, const QString& unit, double surveyed, double simulated) {
        table.rows.push_back({table.rows.empty() || measure == tr("area") ? name : QString(), measure, unit, reportNumber(surveyed),
                              reportNumber(simulated), shareShown(simulated, surveyed)});
    };
    const auto one = [&](const QString& measure, const QString& unit, double value) {
        table.rows.push_back({QString(), measure, unit, dash, dash, reportNumber(value)});
    };
    both(tr("area"), QStringLiteral("m²"), made.survey.area, made.simulated.area);
    if (made.seen) {
        both(tr("area, both surveyed alike"), QStringLiteral("m²"), made.survey.area, made.seen->area);
    }
    if (!made.isFootprint) {
        both(tr("volume with voids"), QStringLiteral("m³"), made.survey.volume, made.simulated.volume);
    }
    double surveyed = 0.0;
    double simulated = 0.0;
    for (std::size_t s = 0; s < made.survey.runOut.size(); ++s) {
        surveyed = std::max(surveyed, made.survey.runOut[s]);
        simulated = std::max(simulated, made.simulated.runOut[s]);
    }
    both(tr("farthest run-out of 95 % of the area"), QStringLiteral("m"), surveyed, simulated);
    one(tr("overlap of the footprints (IoU)"), QString(), made.iou);
    if (made.seen) {
        one(tr("IoU that a perfect simulation reaches on this grid"), QString(), made.seen->reachableIou);
        one(tr("IoU, both surveyed alike"), QString(), made.seen->alikeIou);
    }
    one(tr("centroids apart"), QStringLiteral("m"), made.centroidDistance);
    if (!made.isFootprint) {
        one(tr("heights differ, RMS"), QStringLiteral("m"), made.heightRms);
        one(tr("heights differ, mean"), QStringLiteral("m"), made.heightMean);
        one(tr("surveyed fill"), QStringLiteral("m³"), made.volumes.fill);
        one(tr("surveyed cut"), QStringLiteral("m³"), made.volumes.cut);
        one(tr("surveyed net volume"), QStringLiteral("m³"), made.volumes.net());
        const bool known = made.noise.source != SurveyNoise::Source::Unknown;
        const bool stated = made.noise.source == SurveyNoise::Source::Stated;
        one(!known ? tr("level of detection, not known: every height counts")
                   : (stated ? tr("level of detection, stated") : tr("level of detection, estimated")),
            QStringLiteral("m"), known ? made.noise.detection() : unknown);
        if (stated || made.noise.source == SurveyNoise::Source::Estimated) {
            one(tr("fill also below the level of detection, not counted"), QStringLiteral("m³"), made.volumes.undetectedFill);
            one(tr("cut also below the level of detection, not counted"), QStringLiteral("m³"), made.volumes.undetectedCut);
            one(tr("net volume below the level of detection, not counted"), QStringLiteral("m³"), made.volumes.undetectedNet());
        }
    }
    if (!made.settings.scope.whole()) {
        one(tr("surveyed debris that is not compared"), QStringLiteral("m²"), made.leftOut.surveyedArea);
        one(tr("simulated debris that is not compared"), QStringLiteral("m²"), made.leftOut.simulatedArea);
    }
}

}  // namespace rubble::figures
