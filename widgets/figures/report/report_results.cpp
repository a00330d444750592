#include <QLocale>
#include <algorithm>
#include <cmath>

#include "widgets/figures/number_text.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/report/report_chart.h"
#include "widgets/figures/report/report_sections.h"

namespace rubble::figures {

void ReportSections::addResults() {
    heading(tr("Results"));
    const bool bodies = m_facts.fe->contents().looseBodies;
    text(
        bodies
            ? tr("The first figures show the bodies that are not let go yet, and those that are. The tables and the map after them "
                 "say how much lies where.")
            : tr("The first figures set what the FE result alone shows against the fragments. The tables and the map after them "
                 "say how much lies where.") +
                  (m_facts.floor ? u' ' + tr("Brackets hold what the repeats came to.") : QString()));
    const auto figure = [this](const QImage& picture, const QString& caption) {
        if (!picture.isNull()) {
            ReportFigure made;
            made.picture = picture;
            made.caption = made.words = caption;
            made.source = source();
            m_blocks.push_back(std::move(made));
        }
    };
    figure(
        m_pictures.pairs,
        bodies
            ? tr("Three instants: the bodies that are not let go yet (given), and those that are (simulated), from the same camera")
            : tr("The collapse at three instants: the conventional FE result (computed), and the fragments (simulated) with the "
                 "structure that still stands, from the same camera"));
    figure(m_pictures.end, bodies ? tr("The bodies (simulated) at the end")
                                  : tr("The conventional FE result (computed) and the fragments (simulated) at the end"));
    addMeasures();
    figure(m_pictures.map, tr("Mass of the simulated debris per area at the end"));
    addComponentDebris();
    figure(m_pictures.stages, tr("Four stages of the collapse, simulated, fragments in red"));
    addCourse();
}

void ReportSections::addMeasures() {
    ReportTable table;
    table.caption = m_facts.floor
                        ? tr("Debris at the end of the run, with the least and the largest over it and its %1 repeats, and at "
                             "the end of the FE result")
                              .arg(m_facts.floor->repeats.size())
                        : tr("Debris at the end of the run and at the end of the FE result");
    const std::int64_t moving = m_facts.result->stillMoving;
    table.caption +=
        QLatin1Char(' ') +
        (moving == 0 ? tr("(all at rest at the end of the run)")
                     : tr("(%1 bodies still move at the end of the run)").arg(countText(static_cast<std::size_t>(moving))));
    const bool varied = m_facts.ensemble != nullptr && m_facts.ensemble->done().size() > 1;
    table.columns = QStringList{tr("measure"), tr("unit"), tr("at the end (range)"), tr("at the FE end")};
    table.words = {true, true, false, false};
    table.shares = {0.4, 0.1, 0.32, 0.18};
    if (varied) {
        table.columns << (spreadOf(*m_facts.ensemble, MemberMeasure::RunOut).hasTwentieths()
                              ? tr("over the ensemble, 5 to 95 %")
                              : tr("over the ensemble, least to most"));
        table.words.push_back(false);
        table.shares = {0.34, 0.08, 0.26, 0.12, 0.2};
    }
    // The ensemble lays its members on cells of its own: what depends on them stands in its chapter.
    const auto members = [&](std::optional<MemberMeasure> measure) {
        if (varied) {
            table.rows.back().push_back(measure ? memberSpread(*measure) : QStringLiteral("–"));
        }
    };
    const auto row = [&](const QString& name, const QString& unit, double DebrisFigures::* figure,
                         std::optional<MemberMeasure> measure = std::nullopt) {
        table.rows.push_back(
            {name, unit, rangedNumber(m_facts.atRest.*figure, rangeOver(m_facts, figure)), reportNumber(m_facts.atFeEnd.*figure)});
        members(measure);
    };
    table.rows.push_back({tr("mass of the fragments"), QStringLiteral("t"), reportNumber(1e-3 * m_facts.atRest.mass, ledgerDigits),
                          reportNumber(1e-3 * m_facts.atFeEnd.mass, ledgerDigits)});
    members(std::nullopt);
    row(tr("footprint, 1 m cells"), QStringLiteral("m²"), &DebrisFigures::footprintArea);
    table.rows.push_back({tr("footprint by the cells of the map, %1 m").arg(reportNumber(m_facts.map.map.cell)),
                          QStringLiteral("m²"), reportNumber(m_facts.map.map.ledger.footprintArea), QStringLiteral("–")});
    members(std::nullopt);
    row(tr("core, 95 % of the mass in 2 m cells"), QStringLiteral("m²"), &DebrisFigures::coreArea);
    row(tr("run-out of 95 % of the mass"), QStringLiteral("m"), &DebrisFigures::runOut, MemberMeasure::RunOut);
    row(tr("mean height of the mass"), QStringLiteral("m"), &DebrisFigures::meanHeight, MemberMeasure::MeanHeight);
    row(tr("highest cell of 1 m, mean height"), QStringLiteral("m"), &DebrisFigures::pileHeight);
    const MapLedger& ledger = m_facts.map.map.ledger;
    table.rows.push_back(
        {tr("volume of material"), QStringLiteral("m³"), reportNumber(ledger.volume, ledgerDigits), QStringLiteral("–")});
    members(std::nullopt);
    if (m_facts.map.map.live) {
        table.rows.push_back({tr("fallen live structure, moved farther than %1 m, apart from the fragments")
                                  .arg(reportNumber(m_facts.map.map.liveThreshold, 2)),
                              QStringLiteral("t"), reportNumber(ledger.liveMass / 1000.0, ledgerDigits), QStringLiteral("–")});
        members(std::nullopt);
    }
    table.source = source();
    m_blocks.push_back(std::move(table));
    if (m_facts.atRest.coreArea > m_facts.atRest.footprintArea) {
        text(
            tr("The debris is small for these cells: its core, in cells of 2 m, covers more than its footprint in cells of 1 m. "
               "The debris map has cells that fit the fragments."));
    }
}

void ReportSections::addComponentDebris() {
    const std::size_t components = m_facts.components->list.size();
    std::vector<double> mass(components, 0.0), farthest(components, 0.0), hardest(components, 0.0);
    std::vector<double> first(components, INFINITY), last(components, -INFINITY);
    for (std::size_t f = 0; f < m_facts.fragments->size(); ++f) {
        const Fragment& fragment = m_facts.fragments->list[f];
        const FragmentOutcome& outcome = m_facts.result->fragments[f];
        const std::size_t c = at(fragment.component);
        mass[c] += fragment.mass;
        farthest[c] = std::max(farthest[c], (outcome.finalPosition - outcome.birthPosition).head<2>().norm());
        hardest[c] = std::max(hardest[c], outcome.impactSpeed);
        first[c] = std::min(first[c], fragment.birthTime);
        last[c] = std::max(last[c], fragment.birthTime);
    }
    ReportTable table;
    table.caption = tr("Fragments by component");
    table.columns = QStringList{tr("component"),
                                tr("mass [t]"),
                                tr("first birth [s]"),
                                tr("last birth [s]"),
                                tr("farthest way in plan [m]"),
                                tr("at the hardest hit [m/s]")};
    table.words = {true, false, false, false, false, false};
    for (std::size_t c = 0; c < components; ++c) {
        if (mass[c] > 0.0) {
            table.rows.push_back({QString::fromStdString(m_facts.components->list[c].name).toHtmlEscaped(),
                                  reportNumber(mass[c] / 1000.0, ledgerDigits), reportSeconds(first[c]), reportSeconds(last[c]),
                                  reportNumber(farthest[c]), reportNumber(hardest[c])});
        }
    }
    table.source = source();
    m_blocks.push_back(std::move(table));
    text(
        tr("At the hardest hit: the speed of a fragment just before the hit that changed the motion of its body most, the fastest "
           "of each component. A fragment at the end of a body that turns is faster than the body is as a whole."));
}

void ReportSections::addCourse() {
    ReportChart chart;
    chart.xTitle = tr("time [s]");
    chart.yTitle = tr("energy of all bodies [MJ]");
    const Palette& colours = palette(render::Theme::Print);
    ChartSeries kinetic{tr("kinetic"), colours.fragment, true, false, {}};
    ChartSeries potential{tr("potential"), colours.accent, true, true, {}};
    for (const LedgerRow& row : m_facts.ledger) {
        kinetic.points.push_back({row.time, row.all.kineticEnergy / 1e6, {}});
        potential.points.push_back({row.time, row.potentialEnergy / 1e6, {}});
    }
    if (kinetic.points.size() < 2) {
        return;
    }
    chart.series = {kinetic, potential};
    ReportFigure figure;
    figure.caption = figure.words = m_facts.result->carried.islands > 0
                                        ? tr("Simulated energy of the bodies over time; they enter as their elements are "
                                             "deactivated, or as loose structure that the "
                                             "engine takes over")
                                        : tr("Simulated energy of the bodies over time; they enter as their elements are "
                                             "deactivated, or released at the end of the FE "
                                             "result");
    figure.paint = [chart](QPainter& painter, const QRectF& area, double text) { chart.paint(painter, area, text); };
    figure.aspect = 2.2;
    figure.source = source();
    m_blocks.push_back(std::move(figure));
}

void ReportSections::addConservation() {
    const LedgerErrors& errors = m_facts.result->ledger;
    const EnergyBalance& energy = m_facts.result->energy;
    ReportTable table;
    table.caption = tr("What must be conserved when elements are handed over to bodies, and the energy of the run");
    table.columns = QStringList{tr("quantity"), tr("value")};
    table.words = {true, false};
    table.shares = {0.7, 0.3};
    const auto row = [&](const QString& name, double value, const QString& unit, int digits = 3) {
        table.rows.push_back({name, reportNumber(value, digits) + (unit.isEmpty() ? QString() : QStringLiteral(" ") + unit)});
    };
    // Whole megajoules where there are many: the rows are to be added up.
    const auto energyRow = [&](const QString& name, double joules) {
        const int digits = 1 + static_cast<int>(std::floor(std::log10(std::max(std::abs(joules / 1e6), 1.0))));
        row(name, joules / 1e6, QStringLiteral("MJ"), std::max(3, digits));
    };
    row(tr("mass, bodies against the FE result, largest relative error"), errors.bodyMass, {});
    row(tr("momentum, likewise"), errors.bodyMomentum, {});
    row(tr("angular momentum, likewise"), errors.bodyAngularMomentum, {});
    energyRow(tr("kinetic energy with which fragments became bodies"), energy.kineticIn);
    energyRow(tr("work of gravity"), energy.gravityWork);
    energyRow(tr("work of water, air and ties; below zero they took energy"), energy.effectWork);
    energyRow(tr("work of parting what overlapped at birth"), m_facts.result->births.work);
    energyRow(tr("work of the structure that moved against bodies"), m_facts.result->births.piecePushWork);
    // What was not lost and is not there has left: the balance is made so.
    const double left = energy.kineticIn + energy.gravityWork + energy.effectWork + m_facts.result->births.work +
                        m_facts.result->births.piecePushWork - energy.dissipated - energy.kineticNow;
    energyRow(tr("kinetic energy that left with bodies: of loose structure that gave fragments, and of bodies removed"), left);
    energyRow(tr("lost in contacts"), energy.dissipated);
    energyRow(tr("kinetic energy left at the end"), energy.kineticNow);
    row(tr("gain beyond all sources, share of the work of gravity"), energy.drift, {});
    row(tr("deepest overlap that lasted over 0.5 s"), m_facts.result->health.penetrationSustained, QStringLiteral("m"));
    const double bulking = m_facts.result->bulkingFactor;
    const std::optional<Message> thin = thinPile(bulking, m_facts.result->health.breaches);
    row(thin ? tr("bulking factor of the pile; %1").arg(said(*thin)) : tr("bulking factor of the pile"), bulking, {});
    table.source = source();
    m_blocks.push_back(std::move(table));
    addCarried();
}

/// Loose structure that the engine moved before the FE result ended; nothing where it moved none.
void ReportSections::addCarried() {
    const CarriedStructure& carried = m_facts.result->carried;
    if (carried.islands == 0) {
        return;
    }
    ReportTable table;
    table.caption = tr("Loose structure that the engine moved before the FE result ended");
    table.columns = QStringList{tr("quantity"), tr("value")};
    table.words = {true, false};
    table.shares = {0.7, 0.3};
    const auto tonnes = [&](const QString& name, double mass) {
        table.rows.push_back({name, reportNumber(mass / 1000.0, ledgerDigits) + QStringLiteral(" t")});
    };
    const auto error = [&](const QString& name, const LedgerErrors& errors) {
        table.rows.push_back({name, reportNumber(std::max({errors.bodyMass, errors.bodyMomentum, errors.bodyAngularMomentum}))});
    };
    table.rows.push_back({tr("islands that came loose"), QLocale().toString(static_cast<qlonglong>(carried.islands))});
    tonnes(tr("their mass"), carried.mass);
    tonnes(tr("fragments born from them"), carried.bornMass);
    tonnes(tr("of these, killed by the FE result after their island had come to rest elsewhere"), carried.bornAtRestMass);
    tonnes(tr("and by a blow more than twice as hard as any that the engine had given them"), carried.bornSofterMass);
    tonnes(tr("left of them at the end"), carried.leftMass);
    table.rows.push_back({tr("kinetic energy of deformation that was dropped"),
                          reportNumber(carried.droppedKineticEnergy / 1e6) + QStringLiteral(" MJ")});
    error(tr("mass and momenta against the FE result, largest relative error"), carried.handOvers);
    error(tr("mass and momenta of what was born and left against what there was, likewise"), carried.losses);
    table.source = source();
    m_blocks.push_back(std::move(table));
}

void ReportSections::addAccuracy() {
    heading(tr("Spread of repeats, and agreement with the reference"));
    if (m_facts.floor) {
        text(tr("The run was repeated %1 times with every birth shifted by a micrometre. The largest difference between any two of "
                "these "
                "runs is the repeat floor: no smaller difference says anything.")
                 .arg(m_facts.floor->repeats.size()));
        text(m_facts.reproduced
                 ? tr("The run itself was simulated again for this and came out the same, bit for bit.")
                 : tr("<b>The run itself did not come out the same when it was simulated again</b>; the recorded run was made "
                      "by another build or on another machine. Ranges are still those of repeats."));
        addFloor(*m_facts.floor, tr("The repeat floor: largest difference between the run and its repeats"), source());
    } else {
        notice(tr("No repeats were made for this report, so the spread of its figures is not known."));
    }
    addSweep();
}

void ReportSections::addFloor(const RepeatFloor& floor, const QString& caption, const QString& from) {
    const DebrisDifference& largest = floor.largest;
    ReportTable table;
    table.caption = caption;
    table.columns = QStringList{tr("measure"), tr("floor")};
    table.words = {true, false};
    table.shares = {0.7, 0.3};
    table.rows = {{tr("mass-map difference"), reportNumber(largest.of(Measure::MassMap), 2)},
                  {tr("1 − IoU of the core"), reportNumber(largest.departure(Measure::CoreIou), 2)},
                  {tr("1 − IoU of the footprint"), reportNumber(largest.departure(Measure::FootprintIou), 2)},
                  {tr("run-out [m]"), reportNumber(largest.departure(Measure::RunOut), 2)},
                  {tr("mean height [m]"), reportNumber(largest.departure(Measure::MeanHeight), 2)},
                  {tr("median distance of a fragment between two runs [m]"), reportNumber(largest.of(Measure::MedianDistance), 2)}};
    table.source = from;
    m_blocks.push_back(std::move(table));
}

void ReportSections::addReference() {
    if (!m_facts.reference) {
        text(tr("The reference itself is no longer kept, so what it repeats to is not known."));
        return;
    }
    const RepeatFloor& reference = *m_facts.reference;
    QStringList repeats;
    for (const RepeatRow& repeat : reference.repeats) {
        repeats << shortDigest(repeat.trajectoryHash.hex());
    }
    const QString from =
        tr("From the reference that the sweep kept, trajectory %1, and its repeats: %2.")
            .arg(shortDigest(reference.trajectoryHash.hex()), repeats.isEmpty() ? tr("none") : repeats.join(QStringLiteral(", ")));
    text(tr("In the reference every fragment is its own body: its debris covers %1 m², 95 % of the mass lies within %2 m of the "
            "plan "
            "of what collapsed, and the mass lies at a mean height of %3 m.")
             .arg(reportNumber(reference.figures.footprintArea), reportNumber(reference.figures.runOut),
                  reportNumber(reference.figures.meanHeight)));
    if (reference.repeats.empty()) {
        text(tr("It was not repeated: its own floor is not known.") + QLatin1Char(' ') + from);
        return;
    }
    text(tr("It was repeated %1 times as the run was. A setting that is no farther from it than this floor cannot be told from it.")
             .arg(reference.repeats.size()));
    addFloor(reference, tr("The repeat floor of the reference: largest difference between it and its repeats"), from);
}

void ReportSections::addSweep() {
    std::vector<KnownPoint> points = m_facts.points;
    std::erase_if(points, [](const KnownPoint& point) { return !std::isfinite(point.of(Predicted::MassMap)); });
    if (points.empty()) {
        text(
            tr("No settings of this scene have been compared with the reference, in which every fragment is its own body; how far "
               "this run "
               "is from it is not known. The panel Accuracy and rubble-cli accuracy measure it."));
        return;
    }
    addReference();
    ReportTable table;
    table.caption = tr("Settings of this scene that were compared with the reference, by their number of bodies");
    table.columns = QStringList{tr("setting"),       tr("bodies"),         tr("wall time [s]"), tr("mass-map difference"),
                                tr("footprint IoU"), tr("mean height [m]")};
    table.words = {true, false, false, false, false, false};
    table.shares = {0.34, 0.12, 0.13, 0.14, 0.14, 0.13};
    ReportChart chart;
    chart.xTitle = tr("wall time [s], this machine");
    chart.yTitle = tr("mass-map difference from the reference");
    chart.logX = true;
    ChartSeries series{{}, palette(render::Theme::Print).fragment, false, false, {}};
    for (const KnownPoint& point : points) {
        const bool here = point.machine == m_facts.machine && std::isfinite(point.of(Predicted::WallSeconds));
        table.rows.push_back({QString::fromStdString(point.setting).toHtmlEscaped(),
                              countText(static_cast<std::size_t>(point.bodies)),
                              here ? reportNumber(point.of(Predicted::WallSeconds)) : QStringLiteral("–"),
                              reportNumber(point.of(Predicted::MassMap)), reportNumber(point.of(Predicted::FootprintIou)),
                              reportNumber(point.of(Predicted::MeanHeight))});
        if (here) {
            series.points.push_back({point.of(Predicted::WallSeconds), point.of(Predicted::MassMap),
                                     countText(static_cast<std::size_t>(point.bodies))});
        }
    }
    table.source =
        tr("Each row is a simulation of its own of the same scene, kept in the folder of studies by the fingerprint of the scene; "
           "wall times are those of this machine.");
    m_blocks.push_back(std::move(table));
    if (series.points.size() < 2) {
        return;
    }
    const bool repeated = m_facts.reference && !m_facts.reference->repeats.empty();
    if (repeated || m_facts.floor) {
        chart.band = (repeated ? m_facts.reference : m_facts.floor)->largest.of(Measure::MassMap);
        chart.bandName = repeated ? tr("repeat floor of the reference") : tr("repeat floor of this run");
    }
    chart.series = {series};
    ReportFigure figure;
    figure.caption = figure.words = tr("What agreement with the reference costs in time; beside each point its number of bodies");
    figure.paint = [chart](QPainter& painter, const QRectF& area, double text) { chart.paint(painter, area, text); };
    figure.aspect = 2.0;
    m_blocks.push_back(std::move(figure));
}

}  // namespace rubble::figures
