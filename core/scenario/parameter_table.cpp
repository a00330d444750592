#include <array>
#include <optional>

#include "core/scenario/parameters.h"

namespace rubble {

namespace {

template <class T>
ParameterValue toValue(const T& member) {
    if constexpr (std::is_same_v<T, int>) {
        return static_cast<std::int64_t>(member);
    } else {
        return member;
    }
}

template <class T>
ParameterValue toValue(const std::optional<T>& member) {
    return member ? toValue(*member) : ParameterValue{};
}

template <class T>
void fromValue(T& member, const ParameterValue& value) {
    if constexpr (std::is_same_v<T, int>) {
        member = static_cast<int>(std::get<std::int64_t>(value));
    } else {
        member = std::get<T>(value);
    }
}

template <class T>
void fromValue(std::optional<T>& member, const ParameterValue& value) {
    if (std::holds_alternative<std::monostate>(value)) {
        member.reset();
    } else {
        T inner{};
        fromValue(inner, value);
        member = inner;
    }
}

/// Builds rows of one stage; each call adds one row.
class Table {
public:
    explicit Table(Stage stage) : m_stage(stage) {}

    template <class Access>
    Table& number(std::string_view key, std::string_view unit, double low, double high, Access access, std::string_view label,
                  std::string_view help) {
        Parameter row = plain(key, ParameterKind::Number, access, label, help);
        row.unit = unit;
        row.low = low;
        row.high = high;
        return add(std::move(row));
    }
    template <class Access>
    Table& integer(std::string_view key, double low, double high, Access access, std::string_view label, std::string_view help) {
        Parameter row = plain(key, ParameterKind::Integer, access, label, help);
        row.low = low;
        row.high = high;
        return add(std::move(row));
    }
    template <class Access>
    Table& toggle(std::string_view key, Access access, std::string_view label, std::string_view help) {
        return add(plain(key, ParameterKind::Switch, access, label, help));
    }
    template <class Access>
    Table& text(std::string_view key, Access access, std::string_view label, std::string_view help) {
        return add(plain(key, ParameterKind::Text, access, label, help));
    }
    /// An enumeration whose values are numbered in the order of `choices`.
    template <class Access>
    Table& choice(std::string_view key, std::vector<std::string_view> choices, Access access, std::string_view label,
                  std::string_view help) {
        Parameter row;
        row.key = key;
        row.kind = ParameterKind::Choice;
        row.choices = choices;
        row.stage = m_stage;
        row.label = label;
        row.help = help;
        row.get = [access, choices](const Scenario& scenario, const std::string&) -> ParameterValue {
            return std::string(choices[static_cast<std::size_t>(access(const_cast<Scenario&>(scenario)))]);
        };
        row.set = [access, choices](Scenario& scenario, const std::string&, const ParameterValue& value) {
            const std::string& name = std::get<std::string>(value);
            for (std::size_t i = 0; i < choices.size(); ++i) {
                if (choices[i] == name) {
                    auto& member = access(scenario);
                    member = static_cast<std::remove_reference_t<decltype(member)>>(i);
                }
            }
        };
        return add(std::move(row));
    }
    /// An optional member of ComponentSettings; setting the last one back to automatic drops the component's entry.
    template <class T>
    Table& component(std::string_view key, ParameterKind kind, std::string_view unit, double low, double high,
                     std::optional<T> ComponentSettings::* member, std::string_view label, std::string_view help) {
        Parameter row;
        row.key = key;
        row.kind = kind;
        row.unit = unit;
        row.low = low;
        row.high = high;
        row.automatic = true;
        row.stage = m_stage;
        row.label = label;
        row.help = help;
        row.get = [member](const Scenario& scenario, const std::string& subject) -> ParameterValue {
            const auto entry = scenario.components.find(subject);
            return entry == scenario.components.end() ? ParameterValue{} : toValue(entry->second.*member);
        };
        row.set = [member](Scenario& scenario, const std::string& subject, const ParameterValue& value) {
            fromValue(scenario.components[subject].*member, value);
            if (scenario.components[subject] == ComponentSettings{}) {
                scenario.components.erase(subject);
            }
        };
        return add(std::move(row));
    }

    std::vector<Parameter> rows;

private:
    Table& add(Parameter row) {
        rows.push_back(std::move(row));
        return *this;
    }

    template <class Access>
    Parameter plain(std::string_view key, ParameterKind kind, Access access, std::string_view label, std::string_view help) {
        using T = std::remove_reference_t<decltype(access(std::declval<Scenario&>()))>;
        Parameter row;
        row.key = key;
        row.kind = kind;
        row.automatic = requires(T t) { t.has_value(); };
        row.stage = m_stage;
        row.label = label;
        row.help = help;
        // The accessor only names the member; reading through it changes nothing.
        row.get = [access](const Scenario& scenario, const std::string&) {
            return toValue(access(const_cast<Scenario&>(scenario)));
        };
        row.set = [access](Scenario& scenario, const std::string&, const ParameterValue& value) {
            fromValue(access(scenario), value);
        };
        return row;
    }

    Stage m_stage;
};

#define RUBBLE_AT(path) [](Scenario& s) -> auto& { return s.path; }

std::vector<Parameter> importRows() {
    Table table(Stage::Import);
    table
        .text("status_variable", RUBBLE_AT(import.statusVariable), "Active flag",
              "Name of the element variable that tells active from deactivated. Empty: recognised by name.")
        .integer(
            "active_value", 0, 255, RUBBLE_AT(import.activeValue), "Value of active",
            "Value of the active flag on active elements. Automatic: by the flag's convention, else what most elements have at the "
            "first state.")
        .text("displacement", RUBBLE_AT(import.displacement), "Displacement",
              "Prefix of the nodal displacement variables. Empty: recognised by name. none: the nodes do not move.");
    return std::move(table.rows);
}

std::vector<Parameter> componentRows() {
    Table table(Stage::Components);
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
                   "Whether the component's smallest dimension bounds the Basic Grid.");
    return std::move(table.rows);
}

std::vector<Parameter> fragmentRows() {
    Table table(Stage::Fragments);
    table
        .choice(
            "birth_time", {"state", "exact"}, RUBBLE_AT(fragments.birthTime), "Birth time",
            "state: a fragment is born at the first state that reports its element inactive. exact: at the death time in the file.")
        .choice("revival", {"latch", "follow", "refuse"}, RUBBLE_AT(fragments.revival), "Revived elements",
                "latch: dead is dead. follow: the fragment ends when its element returns. refuse: such a file is an error.")
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
    Table table(Stage::Sizing);
    table
        .number("fps_target", "FPS", 1, 240, RUBBLE_AT(grid.fpsTarget), "Live frame rate",
                "Frames per second of wall clock that live mode should reach.")
        .integer("bodies_max", 1, 10000000, RUBBLE_AT(grid.bodiesMax), "Bodies allowed here",
                 "Most rigid bodies that this machine carries at the live frame rate. More bodies: finer debris, slower run.")
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
    Table table(Stage::Simulation);
    table
        .choice("solver", {"soft-step", "bullet"}, RUBBLE_AT(simulation.solver), "Solver",
                "soft-step: soft contacts in small substeps; piles keep their volume, several times faster in large ones. bullet: "
                "sequential impulses as Bullet has them; large piles squeeze into themselves.")
        .number(
            "step_rate", "1/s", 10, 10000, RUBBLE_AT(simulation.stepRate), "Steps per second",
            "Lower bound; steps are equal within an FE interval and meet every state. More steps: deeper piles hold, slower run.")
        .integer("iterations", 1, 1000, RUBBLE_AT(simulation.iterations), "Solver iterations",
                 "Iterations of the contact solver in each step. Costs time; a smaller step buys more.")
        .choice("cluster_shape", {"axis_box", "oriented_box", "hull", "compound"}, RUBBLE_AT(simulation.shape), "Cluster shape",
                "Collision shape of a cluster. axis_box: as published. oriented_box: same cost, less empty space. hull: closer, "
                "slower. "
                "compound: a box for every fragment, slowest.")
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
        .toggle("ground", RUBBLE_AT(simulation.ground), "Ground", "A level ground that carries the debris.")
        .number("ground_height", "m", -1e6, 1e6, RUBBLE_AT(simulation.groundHeight), "Height of the ground",
                "z of the level ground.")
        .number("friction", "", 0, 10, RUBBLE_AT(simulation.friction), "Friction",
                "Coulomb coefficient of debris on debris, structure and ground.")
        .number("restitution", "", 0, 1, RUBBLE_AT(simulation.restitution), "Restitution", "Normal restitution of a hit.")
        .toggle("freeze", RUBBLE_AT(simulation.freeze), "Freeze bodies at rest",
                "Bodies that have come to rest are held until something disturbs them. Off: a pile creeps and costs time for ever.")
        .number("freeze_speed", "m/s", 0, 10, RUBBLE_AT(simulation.freezeSpeed), "Freeze below",
                "Speed of a body's fastest corner below which it counts as at rest.")
        .number("freeze_delay", "s", 0, 60, RUBBLE_AT(simulation.freezeDelay), "Freeze after", "How long it must stay so.")
        .number("overlap_speed", "m/s", 0, 100, RUBBLE_AT(simulation.overlapSpeed), "Overlap resolved at",
                "Speed at which overlap that exists at birth is resolved, by position only.")
        .number("settle_time", "s", 0, 10000, RUBBLE_AT(simulation.settleTime), "Settle time",
                "How long the run goes on at most after the last FE state, until 99 % of the bodies sleep.")
        .number("frame_rate", "FPS", 0.1, 1000, RUBBLE_AT(simulation.frameRate), "Recorded frames",
                "Frames recorded per second of collapse; FE states are always recorded.");
    return std::move(table.rows);
}

#undef RUBBLE_AT

}  // namespace

std::span<const Parameter> parameterTable() {
    static const std::vector<Parameter> table = [] {
        std::vector<Parameter> all;
        for (auto rows : {importRows, componentRows, fragmentRows, sizingRows, simulationRows}) {
            for (Parameter& row : rows()) {
                all.push_back(std::move(row));
            }
        }
        return all;
    }();
    return table;
}

}  // namespace rubble
