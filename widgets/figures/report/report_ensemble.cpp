#include <cmath>

#include "core/evidence/ensembles/probability_map.h"
#include "core/scenario/parameters.h"
#include "widgets/figures/report/report_sections.h"
#include "widgets/figures/report/spoken_text.h"
#include "widgets/figures/shown_units.h"

namespace rubble::figures {

namespace {

/// "uniform from 0.4 to 0.8", as a member gets it.
QString distributionWords(const VariedSetting& varied) {
    switch (varied.distribution) {
        case Distribution::Uniform:
            return ReportSections::tr("uniform from %1 to %2").arg(reportNumber(varied.first), reportNumber(varied.second));
        case Distribution::Normal:
            return ReportSections::tr("normal, %1 ± %2").arg(reportNumber(varied.first), reportNumber(varied.second));
        case Distribution::Choice:
            break;
    }
    QStringList choices;
    for (const std::string& choice : varied.choices) {
        choices << spokenValue(varied.key, choice).toHtmlEscaped();
    }
    return ReportSections::tr("one of %1").arg(choices.join(QStringLiteral(", ")));
}

}  // namespace

void ReportSections::addEnsemble() {
    heading(tr("What is not known"));
    if (m_facts.ensemble == nullptr) {
        notice(tr("No ensemble was simulated of this case: how far friction, births and other things that are not known move the "
                  "debris is not part of this report.") +
               (m_facts.floor ? u' ' + tr("The ranges above are those of repeats alone.") : QString()));
        return;
    }
    const EnsembleReport& ensemble = *m_facts.ensemble;
    const std::size_t done = ensemble.done().size();
    text(tr("The collapse was simulated %1 times with what is not known drawn anew for each member (seed %2). Members differ by "
            "what "
            "is drawn and by births that are moved by a micrometre.")
             .arg(done)
             .arg(ensemble.settings.seed));
    if (done < ensemble.members.size()) {
        notice(tr("The case asks for %1 members; %2 of them have been simulated, and what follows is of these.")
                   .arg(ensemble.members.size())
                   .arg(done));
    }
    ReportTable drawn;
    drawn.caption = tr("What is drawn for each member");
    drawn.columns = QStringList{tr("setting"), tr("unit"), tr("distribution")};
    drawn.words = {true, true, true};
    for (const VariedSetting& varied : ensemble.settings.varied) {
        const Parameter* row = varied.key == scenarioKey ? nullptr : findParameter(varied.key).first;
        drawn.rows.push_back({(varied.key == scenarioKey ? tr("Scenario") : spokenSetting(varied.key)).toHtmlEscaped(),
                              row != nullptr ? unitShown(escaped(std::string(row->unit))) : QString(), distributionWords(varied)});
    }
    drawn.source = source();
    m_blocks.push_back(std::move(drawn));
    addEnsembleSpread();
}

QString ReportSections::memberSpread(MemberMeasure measure) const {
    if (m_facts.ensemble == nullptr || m_facts.ensemble->done().size() < 2) {
        return QStringLiteral("–");
    }
    const FigureSpread spread = spreadOf(*m_facts.ensemble, measure);
    return tr("%1 to %2").arg(reportNumber(spread.lower()), reportNumber(spread.upper()));
}

/// The run is laid on cells of 1 m without live structure, members as the ensemble says: two highest cells are two figures.
QString ReportSections::ensembleSurface() const {
    const SurfaceSettings& surface = m_facts.ensemble->surface;
    return surface.withFallen ? tr("laid on cells of %1 m with fallen live structure").arg(reportNumber(surface.cell, 2))
                              : tr("laid on cells of %1 m without fallen live structure").arg(reportNumber(surface.cell, 2));
}

QString ReportSections::ensembleWords() const {
    const bool many = spreadOf(*m_facts.ensemble, MemberMeasure::RunOut).hasTwentieths();
    const QString members = many ? tr("nine of ten among %1 members") : tr("all %1 members");
    return tr("With what is not known drawn anew, %1 have a run-out of %2 m. Their debris, %3, covers %4 m², and its highest cell "
              "is "
              "%5 m high in the mean (see section What is not known).")
        .arg(members.arg(m_facts.ensemble->done().size()), memberSpread(MemberMeasure::RunOut), ensembleSurface(),
             memberSpread(MemberMeasure::Footprint), memberSpread(MemberMeasure::PileHeight));
}

void ReportSections::addEnsembleSpread() {
    const EnsembleReport& ensemble = *m_facts.ensemble;
    ReportTable table;
    const bool many = spreadOf(ensemble, MemberMeasure::RunOut).hasTwentieths();
    const QString caption =
        many
            ? tr("Spread over %1 members, %2: mean with its standard error, standard deviation of the members, and the values that "
                 "one member in twenty lies below and above")
            : tr("Spread over %1 members, %2: mean with its standard error, standard deviation of the members, and the least and "
                 "the most of them, for they are too few for quantiles");
    table.caption = caption.arg(QString::number(ensemble.done().size()), ensembleSurface());
    table.columns = QStringList{
        tr("figure"), tr("mean"), tr("± mean"), tr("± members"), many ? tr("5 %") : tr("least"), many ? tr("95 %") : tr("most")};
    table.words = {true, false, false, false, false, false};
    table.shares = {0.4, 0.12, 0.12, 0.12, 0.12, 0.12};
    for (std::size_t k = 0; k < memberMeasureCount; ++k) {
        const auto measure = static_cast<MemberMeasure>(k);
        const MemberMeasureRow& row = memberMeasureRow(measure);
        const FigureSpread spread = spreadOf(ensemble, measure);
        const QString unit = raisedUnits(QString::fromUtf8(row.toldUnit.data(), static_cast<qsizetype>(row.toldUnit.size())));
        const auto told = [&](double value) { return value * row.toldPerUnit; };
        const Message name{"", std::string(row.name), {}};
        const bool same = spread.deviation == 0.0;
        table.rows.push_back({QStringLiteral("%1 [%2]").arg(said(name), unit), reportNumber(told(spread.mean)),
                              same ? tr("none") : reportNumber(told(spread.standardError), 2),
                              same ? tr("none") : reportNumber(told(spread.deviation), 2), reportNumber(told(spread.lower())),
                              reportNumber(told(spread.upper()))});
    }
    QStringList members;
    for (const EnsembleMember* member : ensemble.done()) {
        members << shortDigest(member->trajectoryHash.hex().substr(0, 8));
    }
    constexpr qsizetype named = 8;
    table.source = source() + u' ' +
                   (members.size() > named ? tr("Trajectories of the members: %1 and %2 more.")
                                                 .arg(members.mid(0, named).join(QStringLiteral(", ")))
                                                 .arg(members.size() - named)
                                           : tr("Trajectories of the members: %1.").arg(members.join(QStringLiteral(", "))));
    m_blocks.push_back(std::move(table));
    if (!m_pictures.probability.isNull()) {
        ReportFigure figure;
        figure.picture = m_pictures.probability;
        figure.caption = figure.words =
            tr("Probability that debris reaches into a cell, over %1 members").arg(ensemble.done().size());
        figure.source = source();
        m_blocks.push_back(std::move(figure));
    }
    const std::vector<ConvergenceRow> rows = convergenceOf(ensemble);
    text(tr("For so few members the probability of a cell may be off by %1 in the mean and by %2 at most (one standard error). "
            "That covers what was varied and nothing else: neither what the FE analysis left out nor the size of its mesh.")
             .arg(reportNumber(rows.back().probabilityError, 2), reportNumber(rows.back().worstError, 2)));
}

}  // namespace rubble::figures
