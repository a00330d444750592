#include "core/validation/scene_sets.h"

#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/base/elapsed.h"
#include "core/base/unknown.h"
#include "core/validation/grain_column.h"
#include "core/validation/heap_form.h"
#include "core/validation/packing.h"
#include "core/validation/tilting_table.h"
#include "core/validation/voussoir_arch.h"

namespace rubble {

namespace {

constexpr const char* diceSource =
    "Baker & Kudrolli, Phys. Rev. E 82 (2010) 061304: plastic dice, random loose and random close packing";
constexpr std::int64_t poursByDefault = 2;
constexpr std::int64_t columnsByDefault = 1;

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
        SetVariant variant{poured.name, "poured without shaking: between random loose and random close packing", {}};
        const std::string friction = poured.friction == 0.3 ? "0.3" : poured.friction == 0.5 ? "0.5" : "0.8";
        variant.parameters = {{"friction", friction, "assumed: the source measured none; varied for cubes"},
                              {"restitution", "0.1", "assumed"}};
        set.criteria.push_back({poured.name, "solid_fraction", poured.loose - 0.01, poured.close + 0.01, {}});
        set.variants.push_back(std::move(variant));
    }
    return set;
}

constexpr const char* columnsSource =
    "Lube et al., J. Fluid Mech. 508 (2004) 175: run-out 1.6 a^0.5 and height 0.88 a^(1/6) of tall columns, whatever the grains; "
    "Trepanier & Franklin, Phys. Rev. E 82 (2010) 011308: columns of rods, exponent of the run-out of tall ones 0.6 ± 0.1";
constexpr std::array columnAspects{3.0, 6.0, 12.0};

/// Grains with the law that columns of them are held against.
struct ColumnGrains {
    const char* name;
    const char* words;
    Vec3 sides;  ///< m, of equal volume
    double exponent;
    double within;
};
const std::vector<ColumnGrains>& columnGrains() {
    static const std::vector<ColumnGrains> grains{
        {"columns of cubes", "cubes of 0.18 m: the law of irregular grains", {0.18, 0.18, 0.18}, 0.5, 0.12},
        {"columns of rods", "rods 4 : 1 : 1 of the same volume: the measured exponent of rods", {0.4536, 0.1134, 0.1134}, 0.6, 0.1},
        {"columns of plates",
         "plates 3 : 3 : 1 of the same volume: no measurement of plates is known, so the law of irregular grains",
         {0.2595, 0.2595, 0.0866},
         0.5,
         0.12},
    };
    return grains;
}

ConfidenceInterval meanInterval(const std::vector<double>& values) {
    const MeanAndScatter sample = meanAndScatter(values);
    return {sample.mean, sample.mean - sample.scatter, sample.mean + sample.scatter};
}

std::vector<SetFigure> columnFigures(std::size_t variant, const ValidationOptions& options, const Execution& execution) {
    std::vector<double> exponents, factors, runOuts, heights, fractions;
    for (std::int64_t r = 0; r < options.repeats.value_or(columnsByDefault); ++r) {
        std::vector<std::pair<double, double>> points;
        for (const double aspect : columnAspects) {
            GrainColumn column;
            column.grain = columnGrains()[variant].sides;
            column.aspect = aspect;
            column.seed = static_cast<std::uint64_t>(options.seed + r);
            const ColumnDeposit deposit = collapseOf(column, execution);
            points.emplace_back(deposit.aspect, deposit.runOut);
            runOuts.push_back(deposit.runOut / (1.6 * std::sqrt(deposit.aspect)));
            heights.push_back(deposit.height / (0.88 * std::pow(deposit.aspect, 1.0 / 6.0)));
            fractions.push_back(deposit.solidFraction);
        }
        const PowerLaw law = powerLawThrough(points);
        exponents.push_back(law.exponent);
        factors.push_back(law.factor);
    }
    return {{"run_out_exponent", "", meanInterval(exponents)},
            {"run_out_factor", "", meanInterval(factors)},
            {"run_out_over_law", "", meanInterval(runOuts)},
            {"height_over_law", "", meanInterval(heights)},
            {"solid_fraction", "", meanInterval(fractions)}};
}

ValidationSet columnSet() {
    ValidationSet set;
    set.id = "columns";
    set.title = "Round columns of cubes, rods and plates collapse";
    set.source = columnsSource;
    set.licence = "numbers of a publication";
    for (const ColumnGrains& grains : columnGrains()) {
        set.variants.push_back(
            {grains.name,
             grains.words,
             {{"friction", "0.6", "assumed: the sources find that it matters little"}, {"restitution", "0.1", "assumed"}},
             {}});
        set.criteria.push_back(
            {grains.name, "run_out_exponent", grains.exponent - grains.within, grains.exponent + grains.within, {}});
        set.criteria.push_back({grains.name, "run_out_over_law", 1.0 / 1.6, 1.6, {}});
        set.criteria.push_back({grains.name, "height_over_law", 1.0 / 1.6, 1.6, {}});
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
         "the same wall at 120 steps a second, three times the least of a collapse",
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
    StandingArch{"arch, 240 steps", "the same at 240 steps a second, six times the least of a collapse", {5.0, 15, 0.8, 240.0}},
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
        set.variants.push_back({one.name, one.words, {{"friction", one.friction, "given"}}});
        set.criteria.push_back({one.name, "over_limit", 0.97, 1.03, {}});
    }
    for (const StandingArch& one : standingArches) {
        set.variants.push_back({one.name, one.words, {{"friction", "0.8", "given: nothing slides"}}});
        set.criteria.push_back({one.name, "over_limit", 0.95, 1.05, {}});
    }
    return set;
}

}  // namespace

std::span<const SceneSet> sceneSets() {
    static const std::array sets{SceneSet{packingSet(), packingFigures}, SceneSet{standingSet(), standingFigures},
                                 SceneSet{columnSet(), columnFigures}};
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
