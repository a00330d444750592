#include "core/validation/scene_sets.h"

#include <array>
#include <chrono>

#include "core/base/elapsed.h"
#include "core/base/unknown.h"
#include "core/validation/packing.h"
#include "core/validation/tilting_table.h"
#include "core/validation/voussoir_arch.h"

namespace rubble {

namespace {

constexpr const char* diceSource =
    "Baker & Kudrolli, Phys. Rev. E 82 (2010) 061304: plastic dice, random loose and random close packing";
constexpr std::int64_t poursByDefault = 2;

/// A die with the packings that were measured of it.
struct PouredDie {
    Die die;
    const char* name;
    double loose;
    double close;
    double friction;
};
constexpr std::array pouredDice{
    PouredDie{Die::Cube, "cubes, friction 0.3", 0.54, 0.67, 0.3}, PouredDie{Die::Cube, "cubes, friction 0.5", 0.54, 0.67, 0.5},
    PouredDie{Die::Cube, "cubes, friction 0.8", 0.54, 0.67, 0.8}, PouredDie{Die::Tetrahedron, "tetrahedra", 0.51, 0.64, 0.5},
    PouredDie{Die::Octahedron, "octahedra", 0.52, 0.64, 0.5},     PouredDie{Die::Dodecahedron, "dodecahedra", 0.51, 0.63, 0.5},
    PouredDie{Die::Icosahedron, "icosahedra", 0.50, 0.59, 0.5},
};

std::vector<SetFigure> packingFigures(std::size_t variant, const ValidationOptions& options, const Execution& execution) {
    const PouredDie& poured = pouredDice[variant];
    std::vector<std::vector<double>> fractions(1);
    for (std::int64_t r = 0; r < options.repeats.value_or(poursByDefault); ++r) {
        Pour pour;
        pour.die = poured.die;
        pour.friction = poured.friction;
        pour.seed = static_cast<std::uint64_t>(options.seed + r);
        fractions.front().push_back(pouredSolidFraction(pour, execution));
    }
    const MeanAndScatter sample = meanAndScatter(fractions.front());
    return {{"solid_fraction", "", {sample.mean, sample.mean - sample.scatter, sample.mean + sample.scatter}},
            {"bulking", "", {1.0 / sample.mean, unknown, unknown}}};
}

ValidationSet packingSet() {
    ValidationSet set;
    set.id = "packings";
    set.title = "Dice poured into a vessel";
    set.source = diceSource;
    set.licence = "numbers of a publication";
    for (const PouredDie& poured : pouredDice) {
        SetVariant variant{poured.name, "poured without shaking: between random loose and random close packing", {}, {}};
        const std::string friction = poured.friction == 0.3 ? "0.3" : poured.friction == 0.5 ? "0.5" : "0.8";
        variant.parameters = {{"friction", friction, "assumed: the source measured none; varied for cubes"},
                              {"restitution", "0.1", "assumed"}};
        set.criteria.push_back({poured.name, "solid_fraction", poured.loose - 0.01, poured.close + 0.01, {}});
        set.variants.push_back(std::move(variant));
    }
    return set;
}

/// A wall on the tilting table.
struct TableWall {
    const char* name;
    const char* words;
    const char* friction;
    TiltedWall wall;
};
const std::vector<TableWall>& tableWalls() {
    static const std::vector<TableWall> walls{
        {"cube slides", "a cube of 1 m, friction 0.65: slides", "0.65", {{1.0, 1.0, 1.0}, 1, 1, 0.65}},
        {"cube topples", "a cube of 1 m, friction 1.2: topples", "1.2", {{1.0, 1.0, 1.0}, 1, 1, 1.2}},
        {"pillar topples", "a block of 0.5 m and 1.5 m high, friction 0.65: topples", "0.65", {{0.5, 0.5, 1.5}, 1, 1, 0.65}},
        {"wall across",
         "a wall in running bond, 5 courses of blocks 0.4 x 0.6 x 0.3 m, friction 0.65, tilted across: topples",
         "0.65",
         {{0.4, 0.6, 0.3}, 5, 3, 0.65}},
        {"wall across, 120 steps",
         "the same wall at 120 steps a second, three times what a collapse takes by itself",
         "0.65",
         {{0.4, 0.6, 0.3}, 5, 3, 0.65, 120.0}},
    };
    return walls;
}

/// An arch on its abutments.
struct StandingArch {
    const char* name;
    const char* words;
    VoussoirArch arch;
};
constexpr std::array standingArches{
    StandingArch{"arch", "a semicircle of 15 voussoirs, radius 5 m, friction 0.8: least thickness", {5.0, 15, 0.8, 40.0}},
    StandingArch{
        "arch, 240 steps", "the same at 240 steps a second, six times what a collapse takes by itself", {5.0, 15, 0.8, 240.0}},
};

std::vector<SetFigure> standingFigures(std::size_t variant, const ValidationOptions&, const Execution& execution) {
    if (variant >= tableWalls().size()) {
        const double found = leastArchThickness(standingArches[variant - tableWalls().size()].arch, execution);
        return {{"thickness_over_radius", "", {found, unknown, unknown}},
                {"limit_thickness_over_radius", "", {limitArchThickness, unknown, unknown}},
                {"over_limit", "", {found / limitArchThickness, unknown, unknown}}};
    }
    const TiltedWall& wall = tableWalls()[variant].wall;
    const double found = tiltingAngle(wall, execution), law = limitAngle(wall);
    return {{"angle_deg", "deg", {found, unknown, unknown}},
            {"limit_angle_deg", "deg", {law, unknown, unknown}},
            {"over_limit", "", {found / law, unknown, unknown}}};
}

ValidationSet standingSet() {
    ValidationSet set;
    set.id = "standing";
    set.title = "Blocks and walls on a tilting table, and an arch";
    set.source = "limit analysis of rigid blocks, closed form: a verification, no measurement";
    set.licence = "closed form";
    for (const TableWall& one : tableWalls()) {
        set.variants.push_back({one.name, one.words, {{"friction", one.friction, "given"}}, {}});
        set.criteria.push_back({one.name, "over_limit", 0.97, 1.03, {}});
    }
    for (const StandingArch& one : standingArches) {
        set.variants.push_back({one.name, one.words, {{"friction", "0.8", "given: nothing slides"}}, {}});
        set.criteria.push_back({one.name, "over_limit", 0.95, 1.05, {}});
    }
    return set;
}

}  // namespace

std::span<const SceneSet> sceneSets() {
    static const std::array sets{SceneSet{packingSet(), packingFigures}, SceneSet{standingSet(), standingFigures}};
    return sets;
}

SetResult validateScene(const SceneSet& scene, const ValidationOptions& options, const Execution& execution) {
    SetResult result;
    result.set = &scene.about;
    for (std::size_t v = 0; v < scene.about.variants.size(); ++v) {
        const auto begun = std::chrono::steady_clock::now();
        VariantResult variant;
        variant.variant = scene.about.variants[v];
        variant.used = variant.variant.parameters;
        variant.figures = scene.figures(v, options, execution);
        judge(variant, scene.about);
        variant.seconds = secondsSince(begun);
        result.variants.push_back(std::move(variant));
    }
    return result;
}

}  // namespace rubble
