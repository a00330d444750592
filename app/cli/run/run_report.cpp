#include "app/cli/run/run_report.h"

#include <algorithm>
#include <cmath>

#include "app/cli/frame/health_output.h"
#include "app/cli/frame/text_output.h"
#include "app/cli/run/effects_output.h"
#include "core/analysis/accuracy/loose_beside.h"
#include "core/base/message.h"
#include "core/fe/unit_evidence.h"
#include "core/simulation/health/passed_limits.h"
#include "io/run/run_cautions.h"

namespace rubble::cli {

namespace {

constexpr std::size_t ledgerRows = 12;

std::string whole(std::size_t number) {
    return englishInteger(static_cast<std::int64_t>(number));
}

std::string withUnit(double number, const char* unit) {
    return std::isfinite(number) ? englishNumber(number) + ' ' + unit : "-";
}

std::string percent(double share) {
    return std::isfinite(share) ? englishNumber(100.0 * share) + " %" : "-";
}

Json wallSecondsJson(const Results& results) {
    Json seconds;
    for (int i = 0; i < stageCount; ++i) {
        seconds[std::string(stageName(static_cast<Stage>(i)))] = results.wallSeconds[static_cast<std::size_t>(i)];
    }
    return seconds;
}

Json ledgerJson(const SimulationResult& run, const std::vector<LedgerRow>& ledger) {
    Json object;
    object["mass_error"] = run.ledger.mass;
    object["momentum_error"] = run.ledger.momentum;
    object["angular_momentum_error"] = run.ledger.angularMomentum;
    object["body_mass_error"] = run.ledger.bodyMass;
    object["body_momentum_error"] = run.ledger.bodyMomentum;
    object["body_angular_momentum_error"] = run.ledger.bodyAngularMomentum;
    double dropped = 0.0;
    for (const LedgerRow& row : ledger) {
        dropped += row.droppedKineticEnergy;
    }
    object["dropped_kinetic_energy_j"] = dropped;
    return object;
}

Json errorsJson(const LedgerErrors& errors) {
    return {{"mass_error", errors.mass},
            {"momentum_error", errors.momentum},
            {"angular_momentum_error", errors.angularMomentum},
            {"body_mass_error", errors.bodyMass},
            {"body_momentum_error", errors.bodyMomentum},
            {"body_angular_momentum_error", errors.bodyAngularMomentum}};
}

Json islandsJson(const LiveIslands& islands) {
    return {{"islands", islands.islands},
            {"released", islands.released},
            {"held", islands.held()},
            {"refused", islands.refused},
            {"elements", islands.elements},
            {"released_elements", islands.releasedElements},
            {"mass_kg", islands.mass},
            {"released_mass_kg", islands.releasedMass},
            {"occupied", islands.occupied},
            {"still_moving", islands.stillMoving},
            {"dropped_kinetic_energy_j", islands.droppedKineticEnergy},
            {"ledger", errorsJson(islands.ledger)}};
}

Json carriedJson(const CarriedStructure& carried) {
    return {{"islands", carried.islands},
            {"elements", carried.elements},
            {"mass_kg", carried.mass},
            {"refused", carried.refused},
            {"bodies", carried.bodies},
            {"born", carried.born},
            {"born_mass_kg", carried.bornMass},
            {"born_at_rest_mass_kg", carried.bornAtRestMass},
            {"born_softer_mass_kg", carried.bornSofterMass},
            {"left", carried.left},
            {"left_mass_kg", carried.leftMass},
            {"still_moving", carried.stillMoving},
            {"dropped_kinetic_energy_j", carried.droppedKineticEnergy},
            {"hand_over_ledger", errorsJson(carried.handOvers)},
            {"loss_ledger",
             {{"mass_error", carried.losses.bodyMass},
              {"momentum_error", carried.losses.bodyMomentum},
              {"angular_momentum_error", carried.losses.bodyAngularMomentum}}}};
}

/// Live structure that the engine moved before the FE result ended; nothing where it moved none.
void addCarried(FactList& facts, const CarriedStructure& carried) {
    if (carried.islands == 0 && carried.refused == 0) {
        return;
    }
    facts.add("loose structure, carried",
              counted(carried.islands, "island", "islands") + " with " + counted(carried.elements, "element", "elements") + ", " +
                  tonnesText(carried.mass) + ", went to the engine when they came loose, as " + englishInteger(carried.bodies) +
                  " bodies in all" +
                  (carried.refused > 0 ? "; " + englishInteger(carried.refused) + " could not be handed over" : std::string()));
    facts.add("born from islands", englishInteger(carried.born) + " fragments, " + tonnesText(carried.bornMass) + "; of these " +
                                       tonnesText(carried.bornAtRestMass) +
                                       " were killed by the FE result after the island had come to rest elsewhere, " +
                                       tonnesText(carried.bornSofterMass) +
                                       " by a blow more than twice as hard as any that the engine had given them");
    facts.add("left of islands", englishInteger(carried.left) + " bodies at the end, " + tonnesText(carried.leftMass) + "; " +
                                     englishInteger(carried.stillMoving) + " still move");
}

/// Apart from the fragments: live structure is not what the FE analysis deleted.
void addIslands(FactList& facts, const LiveIslands& islands) {
    facts.add("live islands", englishInteger(islands.islands) + " with " + counted(islands.elements, "element", "elements") + ", " +
                                  tonnesText(islands.mass) + "; " + englishInteger(islands.moving) +
                                  " elements were still moving at the FE end");
    if (islands.released > 0) {
        const LedgerErrors& e = islands.ledger;
        facts.add("loose structure, released",
                  englishInteger(islands.released) + " of them as rigid bodies: " + englishInteger(islands.releasedElements) +
                      " elements, " + tonnesText(islands.releasedMass) + "; " + englishInteger(islands.occupied) +
                      " in occupied space, " + englishInteger(islands.stillMoving) + " still move at the end; against FE mass " +
                      englishNumber(e.bodyMass) + ", momentum " + englishNumber(e.bodyMomentum) + ", angular momentum " +
                      englishNumber(e.bodyAngularMomentum));
    }
    if (islands.held() > 0) {
        facts.add("held structure",
                  englishInteger(islands.held()) + " of them stay where the FE result ends" +
                      (islands.refused > 0 ? "; " + englishInteger(islands.refused) + " could not be released" : std::string()));
    }
}

void addSimulationJson(Json& object, const SimulationResult& run) {
    object["steps"] = run.steps;
    object["time_first_s"] = run.firstTime;
    object["time_fe_end_s"] = run.feEndTime;
    object["time_end_s"] = run.endTime;
    object["ms_per_step"] = {{"mean", run.stepTimes.meanMs}, {"p95", run.stepTimes.p95Ms}, {"worst", run.stepTimes.worstMs}};
    object["share_of_steps_in_time"] = run.stepTimes.shareInTime;
    object["real_time_factor"] = run.stepTimes.realTimeFactor;
    const CheckpointReport& checkpoints = run.checkpoints;
    object["checkpoints"] = {{"resumed_at_s", checkpoints.resumedAt ? Json(*checkpoints.resumedAt) : Json()},
                             {"kept", checkpoints.kept},
                             {"wall_s", checkpoints.seconds}};
    object["energy_drift"] = run.energy.drift;
    object["energy"] = {{"gravity_work_j", run.energy.gravityWork},
                        {"kinetic_in_j", run.energy.kineticIn},
                        {"kinetic_now_j", run.energy.kineticNow},
                        {"dissipated_j", run.energy.dissipated}};
    object["occupied_births"] = {{"births", run.births.births},
                                 {"occupied", run.births.occupied},
                                 {"joined", run.births.joined},
                                 {"median_depth", run.births.medianDepth},
                                 {"left", run.births.left},
                                 {"work_j", run.births.work},
                                 {"piece_push_work_j", run.births.piecePushWork},
                                 {"pieces_yielded", run.births.piecesYielded}};
    object["penetration_max_m"] = run.penetrationMax;
    object["speed_max_m_s"] = run.maxSpeed;
    object["bulking_factor"] = run.bulkingFactor;
    object["asleep_at_end"] = run.asleepAtEnd;
    object["still_moving"] = run.stillMoving;
    object["islands"] = islandsJson(run.islands);
    object["carried"] = carriedJson(run.carried);
    object["live_islands"] = run.islands.islands;
    object["live_island_elements"] = run.islands.elements;
    object["live_island_mass_kg"] = run.islands.mass;
    object["live_island_elements_moving"] = run.islands.moving;
}

void printFragments(std::ostream& out, const FragmentSet& fragments, const Components& components) {
    struct Row {
        std::int64_t fragments = 0;
        double mass = 0.0;
        double firstBirth = INFINITY;
        double lastBirth = -INFINITY;
        double fastest = 0.0;
    };
    std::vector<Row> rows(components.list.size());
    for (const Fragment& fragment : fragments.list) {
        Row& row = rows[at(fragment.component)];
        ++row.fragments;
        row.mass += fragment.mass;
        row.firstBirth = std::min(row.firstBirth, fragment.birthTime);
        row.lastBirth = std::max(row.lastBirth, fragment.birthTime);
        row.fastest = std::max(row.fastest, fragment.velocity.norm());
    }
    printHeading(out, "Fragments: " + whole(fragments.size()));
    TextTable table({{"component", ""},
                     {"fragments", ""},
                     {"mass [kg]", ""},
                     {"first birth [s]", ""},
                     {"last birth [s]", ""},
                     {"fastest [m/s]", ""}});
    for (std::size_t c = 0; c < rows.size(); ++c) {
        if (rows[c].fragments > 0) {
            table.add({textCell(components.list[c].name), integerCell(rows[c].fragments), numberCell(rows[c].mass),
                       numberCell(rows[c].firstBirth), numberCell(rows[c].lastBirth), numberCell(rows[c].fastest)});
        }
    }
    table.print(out);
}

void printClusters(std::ostream& out, const Clustering& clustering) {
    printHeading(out, "Clusters");
    std::size_t largest = 0;
    std::size_t single = 0;
    for (const Cluster& cluster : clustering.list) {
        largest = std::max<std::size_t>(largest, cluster.memberCount);
        single += cluster.memberCount == 1 ? 1 : 0;
    }
    FactList facts;
    facts.add("clusters", whole(clustering.list.size()));
    facts.add("of the Basic Grid", whole(clustering.productGroups));
    facts.add("added by component", whole(clustering.splitByComponent));
    facts.add("added by velocity", whole(clustering.splitByVelocity));
    facts.add("largest", whole(largest) + " fragments");
    facts.add("of one fragment", whole(single));
    facts.print(out);
}

void printRun(std::ostream& out, const SimulationResult& run, const std::array<double, stageCount>& wallSeconds) {
    printHeading(out, "Run");
    FactList facts;
    facts.add("time", englishNumber(run.firstTime) + " s to " + withUnit(run.endTime, "s") + "; the FE result ends at " +
                          withUnit(run.feEndTime, "s"));
    facts.add("bodies", englishInteger(run.bodiesPeak) + " at most, " + englishInteger(run.awakePeak) + " awake at once");
    facts.add("steps", englishInteger(run.steps) + ", " +
                           withUnit(static_cast<double>(run.steps) / std::max(1e-9, run.endTime - run.firstTime), "1/s") +
                           ", mean " + withUnit(run.stepTimes.meanMs, "ms") + ", 95 % below " +
                           withUnit(run.stepTimes.p95Ms, "ms") + ", worst " + withUnit(run.stepTimes.worstMs, "ms"));
    facts.add("real-time factor", englishNumber(run.stepTimes.realTimeFactor) + " from first to last birth; " +
                                      percent(run.stepTimes.shareInTime) + " of the steps took less than the time they simulate");
    std::string stages;
    for (int i = 0; i < stageCount; ++i) {
        stages += (i > 0 ? ", " : "") + std::string(stageName(static_cast<Stage>(i))) + ' ' +
                  withUnit(wallSeconds[static_cast<std::size_t>(i)], "s");
    }
    facts.add("wall time", stages);
    facts.add("at the end", percent(run.asleepAtEnd) + " asleep, " + englishInteger(run.stillMoving) + " bodies still move");
    facts.add("births in occupied space",
              englishInteger(run.births.occupied) + " of " + englishInteger(run.births.births) + " (" +
                  englishInteger(run.births.joined) + " of them inside nothing but what they were joined to), median depth " +
                  percent(run.births.medianDepth) + " of the smallest side, resolving them did " + withUnit(run.births.work, "J") +
                  "; at the end " + englishInteger(run.births.left) + " bodies still lie deeper than 5 % in others from birth");
    facts.add("pieces", "did " + withUnit(run.births.piecePushWork, "J") + " on bodies, gave way " +
                            englishInteger(run.births.piecesYielded) + " times");
    facts.add("deepest penetration", withUnit(run.penetrationMax, "m"));
    facts.add("fastest body", withUnit(run.maxSpeed, "m/s"));
    const std::optional<Message> thin = thinPile(run.bulkingFactor, run.health.breaches);
    facts.add("bulking factor",
              std::isfinite(run.bulkingFactor) ? englishNumber(run.bulkingFactor) + (thin ? ", " + englishText(*thin) : "") : "-");
    addIslands(facts, run.islands);
    addCarried(facts, run.carried);
    facts.add("trajectory hash", run.trajectoryHash.hex());
    facts.print(out);
}

/// A hundred rows tell a reader less than a dozen: every so many of them, and the last.
template <class Row>
std::vector<Row> someOf(const std::vector<Row>& rows) {
    std::vector<Row> shown;
    const std::size_t stride = std::max<std::size_t>(1, (rows.size() + ledgerRows - 1) / ledgerRows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i % stride == 0 || i + 1 == rows.size()) {
            shown.push_back(rows[i]);
        }
    }
    return shown;
}

/// What islands brought when they came, and how they shared out what they lost.
void printIslandRows(std::ostream& out, const IslandRows& islands) {
    if (!islands.handOvers.empty()) {
        const std::vector<LedgerRow> shown = someOf(islands.handOvers);
        TextTable table({{"islands at [s]", ""}, {"handed over [kg]", ""}, {"kinetic in [J]", ""}, {"dropped [J]", ""}});
        for (const LedgerRow& row : shown) {
            table.add({numberCell(row.time), numberCell(row.bodies.mass), numberCell(row.bodies.kineticEnergy),
                       numberCell(row.droppedKineticEnergy)});
        }
        table.print(out);
        if (shown.size() < islands.handOvers.size()) {
            out << "  (" << shown.size() << " of " << islands.handOvers.size() << " rows)\n";
        }
    }
    if (!islands.losses.empty()) {
        const std::vector<IslandLoss> shown = someOf(islands.losses);
        TextTable table({{"losses at [s]", ""}, {"islands had [kg]", ""}, {"born from them [kg]", ""}, {"left of them [kg]", ""}});
        for (const IslandLoss& loss : shown) {
            table.add(
                {numberCell(loss.time), numberCell(loss.before.mass), numberCell(loss.born.mass), numberCell(loss.left.mass)});
        }
        table.print(out);
        if (shown.size() < islands.losses.size()) {
            out << "  (" << shown.size() << " of " << islands.losses.size() << " rows)\n";
        }
    }
}

std::string errorsText(double mass, double momentum, double angularMomentum) {
    return "mass " + englishNumber(mass) + ", momentum " + englishNumber(momentum) + ", angular momentum " +
           englishNumber(angularMomentum);
}

void addLedgerErrors(FactList& facts, const SimulationResult& run) {
    const LedgerErrors& e = run.ledger;
    facts.add("fragments against FE", errorsText(e.mass, e.momentum, e.angularMomentum));
    facts.add("bodies against FE", errorsText(e.bodyMass, e.bodyMomentum, e.bodyAngularMomentum) + " (largest relative errors)");
    if (run.carried.islands > 0) {
        const LedgerErrors& taken = run.carried.handOvers;
        const LedgerErrors& lost = run.carried.losses;
        facts.add("islands against FE", errorsText(taken.bodyMass, taken.bodyMomentum, taken.bodyAngularMomentum) +
                                            "; deformation dropped " + withUnit(run.carried.droppedKineticEnergy, "J"));
        facts.add("losses of islands",
                  errorsText(lost.bodyMass, lost.bodyMomentum, lost.bodyAngularMomentum) + ", born and left against what they had");
    }
}

void printLedger(std::ostream& out, const SimulationResult& run, const std::vector<LedgerRow>& ledger, const IslandRows& islands) {
    printHeading(out, "Ledger");
    // All of them are in the table of --csv.
    const std::vector<LedgerRow> shown = someOf(ledger);
    TextTable table({{"time [s]", ""},
                     {"handed over [kg]", ""},
                     {"kinetic in [J]", ""},
                     {"dropped [J]", ""},
                     {"bodies [kg]", ""},
                     {"kinetic [J]", ""},
                     {"potential [J]", ""},
                     {"piece work [J]", ""},
                     {"overlap work [J]", ""}});
    for (const LedgerRow& row : shown) {
        table.add({numberCell(row.time), numberCell(row.bodies.mass), numberCell(row.bodies.kineticEnergy),
                   numberCell(row.droppedKineticEnergy), numberCell(row.all.mass), numberCell(row.all.kineticEnergy),
                   numberCell(row.potentialEnergy), numberCell(row.pieceWork), numberCell(row.overlapWork)});
    }
    table.print(out);
    if (shown.size() < ledger.size()) {
        out << "  (" << shown.size() << " of " << ledger.size() << " rows; --csv writes all)\n";
    }
    printIslandRows(out, islands);
    FactList facts;
    addLedgerErrors(facts, run);
    facts.add("energy", "gravity did " + withUnit(run.energy.gravityWork, "J") + ", hand-overs brought " +
                            withUnit(run.energy.kineticIn, "J") + ", contacts took " + withUnit(run.energy.dissipated, "J") +
                            "; gain beyond these " + percent(run.energy.drift) + " of the gravity work");
    facts.print(out);
}

Json terrainJson(const io::TerrainInput& terrain) {
    if (!terrain.grid) {
        return nullptr;
    }
    const TerrainGrid& grid = *terrain.grid;
    Json object{{"path", terrain.path},
                {"sha256", terrain.sha256},
                {"columns", grid.nx()},
                {"rows", grid.ny()},
                {"cell_m", grid.cell()},
                {"x_m", grid.x0()},
                {"y_m", grid.y0()},
                {"lowest_m", grid.lowest()},
                {"highest_m", grid.highest()},
                {"digest", grid.digest().hex()}};
    object["control_points"] = Json();
    if (terrain.fit) {
        Json residuals = Json::array();
        for (const Vec3& residual : terrain.fit->residuals) {
            residuals.push_back({residual.x(), residual.y(), residual.z()});
        }
        object["control_points"] = {{"used", terrain.fit->used},
                                    {"scale", terrain.fit->scale},
                                    {"angle_rad", terrain.fit->angle},
                                    {"rms_plan_m", terrain.fit->rmsPlan},
                                    {"rms_height_m", terrain.fit->rmsHeight},
                                    {"residuals_m", residuals}};
    }
    object["surroundings"] = Json::array();
    for (const io::SiteFile& file : terrain.files) {
        if (terrain.collided && file.input != terrain.orthophotoInput) {
            Json mesh{{"path", file.path}, {"sha256", file.sha256}};
            if (file.offset != Vec3::Zero()) {
                mesh["offset_m"] = {file.offset.x(), file.offset.y(), file.offset.z()};
            }
            object["surroundings"].push_back(std::move(mesh));
        }
    }
    return object;
}

std::string terrainText(const io::TerrainInput& terrain) {
    const TerrainGrid& grid = *terrain.grid;
    return terrain.path + ", " + englishInteger(static_cast<std::int64_t>(grid.nx())) + " by " +
           englishInteger(static_cast<std::int64_t>(grid.ny())) + " heights at " + englishNumber(grid.cell()) +
           " m, z = " + englishNumber(grid.lowest()) + " to " + englishNumber(grid.highest()) + " m";
}

}  // namespace

std::optional<Finding> RunReport::beside() const {
    return looseBesideCaution(results.sizing->fpsTarget, *results.simulation, subject.inputs.fe->mesh().elementCount());
}

std::vector<Caution> RunReport::cautions() const {
    RunStanding standing = standingOf(*results.simulation, results.fragments->size(), taint.acknowledgement.has_value());
    standing.unplaced = io::unplacedSystem(subject.inputs.frame, subject.theCase.site);
    standing.unsaidUnits = unsaidUnits(subject.inputs.fe->contents().findings);
    const std::vector<Message> opened = placeDoubts(subject.terrain.findings);
    standing.placeDoubts.insert(standing.placeDoubts.begin(), opened.begin(), opened.end());
    tellInputs(standing, findings, subject.scenario.fragments.birthVelocity);
    return runCautions(standing);
}

Json RunReport::json() const {
    const SimulationResult& run = *results.simulation;
    Json object;
    object["elements"] = subject.inputs.fe->mesh().elementCount();
    object["fragments"] = results.fragments->size();
    object["clusters"] = results.clustering->list.size();
    object["bodies_peak"] = run.bodiesPeak;
    object["awake_peak"] = run.awakePeak;
    addSizingJson(object, *results.sizing);
    addSimulationJson(object, run);
    object["effects"] = effectsJson(run.effects);
    object["ms_per_step_all"] = run.stepTimes.allMs;
    object["ms_per_step_rest"] = run.stepTimes.restMs();
    object["ms_per_step_costs"] = costsJson(run);
    object["wall_s"] = wallSecondsJson(results);
    object["ledger"] = ledgerJson(run, ledger);
    object["health"] = healthJson(run);
    object["tainted"] = taint.tainted();
    object["cautions"] = cautionsJson(cautions());
    object["acknowledged"] = acknowledgedJson(taint);
    object["warnings"] = findingsJson(findings, beside());
    object["trajectory_hash"] = run.trajectoryHash.hex();
    object["scenario"] = subject.scenarioName;
    object["fe"] = {{"path", subject.fePath}, {"sha256", subject.inputs.fe->contents().sha256}};
    object["terrain"] = terrainJson(subject.terrain);
    object["units"] = subject.inputs.fe->contents().unitsFrom;
    object["run"] = runPath.empty() ? Json() : Json(runPath);
    object["exports"] = files;
    return object;
}

void RunReport::print(std::ostream& out) const {
    out << subject.fePath << ", scenario \"" << subject.scenarioName << "\"\n";
    out << "units " << subject.inputs.fe->contents().unitsFrom << '\n';
    if (subject.terrain.grid) {
        out << "terrain " << terrainText(subject.terrain) << '\n';
    }
    if (results.fragments->list.empty()) {
        out << "\nNo element dies in this result: there are no fragments"
            << (results.simulation->islands.released > 0 ? ".\n" : ", and nothing moves.\n");
    } else {
        printFragments(out, *results.fragments, *results.components);
    }
    printSizing(out, *results.sizing, *results.fragments, *results.components, subject.inputs.fe->mesh(), beside());
    printClusters(out, *results.clustering);
    printRun(out, *results.simulation, results.wallSeconds);
    printHealth(out, *results.simulation, taint);
    printEffects(out, *results.simulation);
    printLedger(out, *results.simulation, ledger, islands);
    printFindings(out, findings);
    if (!runPath.empty() || !files.empty()) {
        printHeading(out, "Files");
        for (const std::string& path : files) {
            out << "  " << path << '\n';
        }
        if (!runPath.empty()) {
            out << "  " << runPath << '\n';
        }
    }
}

TextTable ledgerTable(const std::vector<LedgerRow>& ledger) {
    std::vector<TextTable::Column> columns{{"", "time_s"}, {"", "state"}};
    for (const char* who : {"fe", "fragments", "clusters", "bodies", "all"}) {
        for (const char* what :
             {"mass_kg", "momentum_x_kg_m_s", "momentum_y_kg_m_s", "momentum_z_kg_m_s", "angular_momentum_x_kg_m2_s",
              "angular_momentum_y_kg_m2_s", "angular_momentum_z_kg_m2_s", "kinetic_energy_j"}) {
            columns.push_back({"", std::string(who) + '_' + what});
        }
    }
    for (const char* what : {"dropped_kinetic_energy_j", "potential_energy_j", "piece_work_j", "overlap_work_j"}) {
        columns.push_back({"", what});
    }
    TextTable table(std::move(columns));
    for (const LedgerRow& row : ledger) {
        std::vector<Cell> cells{numberCell(row.time), integerCell(row.state)};
        for (const Momenta* momenta : {&row.fe, &row.fragments, &row.clusters, &row.bodies, &row.all}) {
            cells.push_back(numberCell(momenta->mass));
            for (int i = 0; i < 3; ++i) {
                cells.push_back(numberCell(momenta->linear[i]));
            }
            for (int i = 0; i < 3; ++i) {
                cells.push_back(numberCell(momenta->angular[i]));
            }
            cells.push_back(numberCell(momenta->kineticEnergy));
        }
        for (const double value : {row.droppedKineticEnergy, row.potentialEnergy, row.pieceWork, row.overlapWork}) {
            cells.push_back(numberCell(value));
        }
        table.add(std::move(cells));
    }
    return table;
}

}  // namespace rubble::cli
