#include "core/fe/units.h"
#include "core/scenario/parameter_rows.h"

namespace rubble {

namespace {

std::vector<Parameter> importRows() {
    ParameterRows table(Stage::Import);
    table
        .text("status_variable", RUBBLE_AT(import.statusVariable), "Active flag",
              "Name of the element variable that tells active from deactivated. Empty: recognised by name.")
        .integer(
            "active_value", 0, 255, RUBBLE_AT(import.activeValue), "Value of active",
            "Value of the active flag on active elements. Automatic: by the flag's convention, else what most elements have at the "
            "first state.")
        .text("displacement", RUBBLE_AT(import.displacement), "Displacement",
              "Prefix of the nodal displacement variables. Empty: recognised by name. none: the nodes do not move.")
        .choice(
            "units", unitChoices(), RUBBLE_AT(import.units), "Units of the file",
            "What the file counts mass, length and time in. frame: as the frame of the case says. auto: what densities, size and "
            "free fall in the file fit, if only one system does; inspect says which and why.")
        .choice(
            "up_axis", upAxisChoices(), RUBBLE_AT(import.upAxis), "Up axis of the file",
            "Axis of the file that points up. frame: as the frame of the case says. auto: against the free fall that is seen in "
            "the file.")
        .toggle("only_this_file", RUBBLE_AT(import.onlyThisFile), "Only this file",
                "Open the file by itself: others whose names differ only in a number are not taken for its states, as with "
                "variants of a design.")
        .text("dead_parts", RUBBLE_AT(import.deadParts), "Parts of the dead",
              "Parts (blocks, materials) whose elements are dead while they belong to them, by name or number, with semicolons "
              "between. Empty: recognised by name where elements move into them.");
    return std::move(table.rows);
}

std::vector<Parameter> componentRows() {
    ParameterRows table(Stage::Components);
    table
        .number("default_density", "kg/m3", 1, 25000, RUBBLE_AT(assumptions.density), "Assumed density",
                "Density where neither the file nor a component setting gives one; each use is counted as a finding.")
        .number("default_thickness", "m", 1e-4, 10, RUBBLE_AT(assumptions.thickness), "Assumed thickness",
                "Thickness of shells where neither the file nor a component setting gives one.")
        .number("default_area", "m2", 1e-8, 100, RUBBLE_AT(assumptions.area), "Assumed section",
                "Cross-section of beams where neither the file nor a component setting gives one.")
        .component("component[*].density", ParameterKind::Number, "kg/m3", 1, 25000, &ComponentSettings::density, "Density",
                   "Density of one component; takes the place of what the file says.")
        .component("component[*].section", ParameterKind::Number, "m or m2", 1e-8, 100, &ComponentSettings::section,
                   "Thickness or section",
                   "Thickness of one component's shells, cross-section of its beams; takes the place of what the file says.")
        .component("component[*].structural", ParameterKind::Switch, "", 0, 1, &ComponentSettings::structural, "Limits the grid",
                   "Whether the component's smallest dimension bounds the Basic Grid.")
        .componentMaterial("component[*].material", "Material",
                           "What one component is made of: decides friction and restitution, and whether clusters break up. "
                           "Automatic: from its density: from 7,000 to 9,000 kg/m3 steel, from 2,550 to 3,500 stone, from 1,400 to "
                           "2,100 masonry, anything else concrete.")
        .componentSwitch("component[*].reinforced", &ComponentSettings::reinforced, "Reinforced",
                         "Steel runs through the component: neighbouring clusters of it are tied (effect ties).");
    return std::move(table.rows);
}

std::vector<Parameter> fragmentRows() {
    ParameterRows table(Stage::Fragments);
    table
        .choice(
            "birth_time", {"state", "exact"}, RUBBLE_AT(fragments.birthTime), "Birth time",
            "state: a fragment is born at the first state that reports its element inactive. exact: at the death time in the file.")
        .choice("revival", {"latch", "follow", "refuse"}, RUBBLE_AT(fragments.revival), "Revived elements",
                "latch: dead is dead. follow: the fragment ends when its element returns. refuse: such a file is an error.")
        .number(
            "birth_window", "s", 0, 1000, RUBBLE_AT(fragments.birthWindow), "Birth window",
            "What dies within this time becomes debris together, at the first state of it, so that one cluster can hold what the "
            "states part: fewer and fuller bodies, which leave the FE result a little earlier. 0: each state by itself. The "
            "reference does not read it, nor does birth_time = exact.")
        .choice("birth_velocity", {"fe", "rest"}, RUBBLE_AT(fragments.birthVelocity), "Birth velocity",
                "fe: fragments keep the velocity their element had. rest: they are born at rest, as in the published method.")
        .number("minimum_thickness_ratio", "", 0.001, 1, RUBBLE_AT(fragments.minimumThicknessRatio), "Thinnest fragment",
                "Smallest half extent of a fragment as a share of its longest; thinner solids are thickened and counted.")
        .number("minimum_half_extent", "m", 1e-4, 1, RUBBLE_AT(fragments.minimumHalfExtent), "Smallest half extent",
                "Smallest half extent of a fragment; thinner solids are thickened and counted.")
        .number("birth_shift", "m", 0, 1, RUBBLE_AT(fragments.birthShift), "Birth shift",
                "Moves every birth place at random by this much: shows how far a result repeats.")
        .integer("seed", 0, 4294967295.0, RUBBLE_AT(fragments.seed), "Seed", "Seed of the birth shift.");
    return std::move(table.rows);
}

std::vector<Parameter> sizingRows() {
    ParameterRows table(Stage::Sizing);
    table
        .number("fps_target", "FPS", 1, 240, RUBBLE_AT(grid.fpsTarget), "Live frame rate",
                "Frames per second of wall clock that live mode should reach.")
        .integer("bodies_max", 1, 10000000, RUBBLE_AT(grid.bodiesMax), "Bodies allowed here",
                 "Most rigid bodies that this machine carries at the live frame rate. More bodies: finer debris, slower run.")
        .number("awake_time", "s", 0, 1e6, RUBBLE_AT(grid.awakeTime), "Awake after birth",
                "How long a body is taken to move: bodies at rest cost next to nothing, so those born this long ago leave their "
                "place among the bodies allowed. Shorter: more and smaller clusters where a collapse lasts long.")
        .choice(
            "grouping", {"nested", "axes"}, RUBBLE_AT(grid.grouping), "Grouping",
            "nested: the fragments of a component that are born together are cut in two, again and again, until each cluster is "
            "as compact as a full box of the Basic Grid in the proportions of its own fragments. axes: those with the same groups "
            "along x, y and z, as published.")
        .number("multiple", "x d", 0.01, 1000, RUBBLE_AT(grid.multiple), "Multiple of mean distance",
                "Size of the Basic Grid as a multiple of the mean distance of adjacent fragments. Automatic: the smallest that "
                "keeps to "
                "the bodies allowed.")
        .number("grid_l", "m", 1e-6, 1e6, RUBBLE_AT(grid.length), "Size along x",
                "Size of the Basic Grid along x. Automatic: from the multiple.")
        .number("grid_w", "m", 1e-6, 1e6, RUBBLE_AT(grid.width), "Size along y",
                "Size of the Basic Grid along y. Automatic: from the multiple.")
        .number("grid_h", "m", 1e-6, 1e6, RUBBLE_AT(grid.height), "Size along z",
                "Size of the Basic Grid along z. Automatic: from the multiple.")
        .toggle("across_components", RUBBLE_AT(grid.acrossComponents), "Clusters across components",
                "Lets one cluster hold fragments of several components, as the published method does when its grid is too large.")
        .toggle("one_body_per_fragment", RUBBLE_AT(grid.oneBodyPerFragment), "One body per fragment",
                "Every fragment moves alone: the reference run. Slow.")
        .number("velocity_tolerance", "m/s", 0, 1000, RUBBLE_AT(grid.velocityTolerance), "Velocity tolerance",
                "Fragments that depart from their cluster's rigid motion by more than this are split off. 0: no split.");
    return std::move(table.rows);
}

std::vector<Parameter> simulationRows() {
    ParameterRows table(Stage::Simulation);
    table
        .choice("solver", {"soft-step", "bullet"}, RUBBLE_AT(simulation.solver), "Solver",
                "soft-step: soft contacts in small substeps; piles keep their volume, several times faster in large ones. bullet: "
                "sequential impulses as Bullet has them; large piles squeeze into themselves.")
        .number(
            "step_rate", "1/s", 10, 10000, RUBBLE_AT(simulation.stepRate), "Steps per second",
            "Lower bound; steps are equal within an FE interval and meet every state. More steps: deeper piles hold, slower run. "
            "Automatic: 40 for bodies of up to 0.3 m, up to 60 for more than 10,000 of them, fewer with the square root of their "
            "size down to 20, or 40 where the engine moves loose structure, until the FE result has ended and what still falls "
            "then has landed; bodies of a table 40 to 480, so that one that falls over its edge turns by 0.75 degrees in a step; "
            "always 60 for bullet.")
        .integer("iterations", 1, 1000, RUBBLE_AT(simulation.iterations), "Solver iterations",
                 "Iterations of Bullet's contact solver in each step. Costs time; a smaller step buys more.")
        .integer(
            "substeps", 1, 64, RUBBLE_AT(simulation.substeps), "Substeps",
            "Parts in which the soft-step solver takes a step, contacts found once for all. It takes more by itself where thin "
            "bodies would sink into each other under their load. Automatic: 4, or 12 where the engine moves loose structure and 8 "
            "once the FE result has ended and what still falls then has landed.")
        .choice("cluster_shape", {"axis_box", "oriented_box", "hull", "compound", "bricks", "auto"}, RUBBLE_AT(simulation.shape),
                "Cluster shape",
                "Collision shape of a cluster. axis_box: as published. oriented_box: same cost, less empty space. hull: closer, "
                "slower. compound: a box for every fragment, slowest. bricks: boxes of the volume of the fragments, joined where "
                "they leave next to no space between them, or up to 0.4 of the grid's cell half of it at most. auto: bricks where "
                "the engine moves loose structure, oriented_box where the FE result does (loose_structure).")
        .number("box_bulking", "", 1, 1000, RUBBLE_AT(simulation.boxBulking), "Bulking of a box",
                "Largest volume of a cluster's box over that of its fragments. A box around scattered fragments holds mostly what "
                "is not "
                "its own; it is drawn in towards its centre of mass to this. At 1 the voids between boxes swell the pile as rubble "
                "does, by "
                "1.3 to 1.8. 1000: never drawn in, as published.")
        .choice(
            "pieces", {"none", "component_box", "grid_boxes", "surface"}, RUBBLE_AT(simulation.pieces), "Moving structure",
            "How the active structure collides. component_box: one box for each component, as published. grid_boxes: boxes of its "
            "active elements on a grid. surface: every active element at the surface.")
        .number("piece_size", "m", 0.05, 1000, RUBBLE_AT(simulation.pieceSize), "Size of grid boxes",
                "Cell size of the grid boxes. Smaller: closer to the structure, slower.")
        .number("gravity", "m/s2", 0, 1000, RUBBLE_AT(simulation.gravity), "Gravity", "Acceleration downwards.")
        .number("ground_height", "m", -1e6, 1e6, RUBBLE_AT(simulation.groundHeight), "Height of the ground",
                "z of the level ground.")
        .number("friction", "", 0, 10, RUBBLE_AT(simulation.friction), "Friction",
                "Coulomb coefficient of every contact. Automatic: by pair of materials.")
        .number("restitution", "", 0, 1, RUBBLE_AT(simulation.restitution), "Restitution",
                "Normal restitution of every hit. Automatic: by pair of materials.")
        .number(
            "friction_level", "", 0, 1, RUBBLE_AT(simulation.frictionLevel), "Level of friction",
            "Where the friction of each pair of materials lies in the range of its source: 0 the least, 1 the greatest, for all "
            "pairs alike. A pair that was set stays. Automatic: the number of the table.")
        .number("restitution_level", "", 0, 1, RUBBLE_AT(simulation.restitutionLevel), "Level of restitution",
                "Where the restitution of each pair of materials lies in the range of its source: 0 the least, 1 the greatest, for "
                "all pairs alike. A pair that was set stays. Automatic: the number of the table.")
        .toggle("freeze", RUBBLE_AT(simulation.freeze), "Freeze bodies at rest",
                "Bodies that have come to rest are held until something disturbs them. Off: a pile creeps and costs time for ever.")
        .number("freeze_speed", "m/s", 0, 10, RUBBLE_AT(simulation.freezeSpeed), "Freeze below",
                "Speed of a body's fastest corner below which it counts as at rest.")
        .number("freeze_delay", "s", 0, 60, RUBBLE_AT(simulation.freezeDelay), "Freeze after", "How long it must stay so.")
        .number("overlap_speed", "m/s", 0, 100, RUBBLE_AT(simulation.overlapSpeed), "Overlap resolved at",
                "Speed at which overlap that exists at birth is resolved, by position only.")
        .number(
            "overlap_time", "s", 0, 10000, RUBBLE_AT(simulation.overlapTime), "Overlap resolved for",
            "How long two bodies are brought apart where one was born in the other, or was pressed into it by such; what is left "
            "then stays, so that the pile can come to rest. Longer: looser piles that rest later. The time counts from the later "
            "birth of the two where the engine moves loose structure (loose_structure), else for each contact. Automatic: 1 s "
            "there, "
            "else 7 s.")
        .toggle("bounce_friction", RUBBLE_AT(simulation.bounceFriction), "Friction of bounces",
                "The impulse of a bounce rubs by Coulomb's law as the impact does, soft-step solver only. Off: blocks that fly or "
                "roll keep "
                "too much speed along the ground, a tenth at restitution 0.1. On by itself for a table of bodies, off for FE "
                "results, whose "
                "trajectories were made without.")
        .number("settle_time", "s", 0, 10000, RUBBLE_AT(simulation.settleTime), "Settle time",
                "How long the run goes on at most after the last FE state, until 99 % of the bodies sleep.")
        .number("frame_rate", "FPS", 0.1, 1000, RUBBLE_AT(simulation.frameRate), "Recorded frames",
                "Frames recorded per second of collapse; FE states are always recorded.")
        .toggle(
            "auto_remedy", RUBBLE_AT(simulation.autoRemedy), "Smaller steps when unhealthy",
            "Halves the steps for 0.5 s whenever energy is gained or bodies lie inside each other beyond the limits of the health "
            "monitor. Costs time only then; the run says when it did.");
    return std::move(table.rows);
}

}  // namespace

std::span<const Parameter> parameterTable() {
    static const std::vector<Parameter> table = [] {
        std::vector<Parameter> all;
        for (auto rows : {importRows, componentRows, fragmentRows, sizingRows, simulationRows, effectRows}) {
            for (Parameter& row : rows()) {
                all.push_back(std::move(row));
            }
        }
        return all;
    }();
    return table;
}

}  // namespace rubble
