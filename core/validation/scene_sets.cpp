#include "core/validation/scene_sets.h"

#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/analysis/accuracy/world_pool.h"
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

std::size_t pours(const ValidationOptions& options) {
    return static_cast<std::size_t>(options.repeats.value_or(poursByDefault));
}

std::vector<double> poured(std::size_t variant, std::size_t piece, const ValidationOptions& options, const Execution& execution) {
    Pour pour;
    pour.die = pouredDice[variant].die;
    pour.friction = pouredDice[variant].friction;
    pour.seed = static_cast<std::uint64_t>(options.seed) + piece;
    return {pouredSolidFraction(pour, execution)};
}

/// One number of each piece.
std::vector<double> valuesAt(const std::vector<std::vector<double>>& found, std::size_t which) {
    std::vector<double> values;
    for (const std::vector<double>& piece : found) {
        values.push_back(piece[which]);
    }
    return values;
}

std::vector<SetFigure> packingFigures(std::size_t, const std::vector<std::vector<double>>& found) {
    const MeanAndScatter sample = meanAndScatter(valuesAt(found, 0));
    return {{"solid_fraction", "", {sample.mean, sample.mean - sample.scatter, sample.mean + sample.scatter}},
            {"bulking", "", {1.0 / sample.mean, unknown, unknown}}};
}

ValidationSet packingSet() {
    ValidationSet set;
    set.id = "packings";
    set.title = "Dice poured into a vessel";
    set.source = diceSource;
    set.licence = "numbers of a publication";
    for (const PouredDie& die : pouredDice) {
        SetVariant variant{die.name, "poured without shaking: between random loose and random close packing", {}};
        const std::string friction = die.friction == 0.3 ? "0.3" : die.friction == 0.5 ? "0.5" : "0.8";
        variant.parameters = {{"friction", friction, "assumed: the source measured none; varied for cubes"},
                              {"restitution", "0.1", "assumed"}};
        set.criteria.push_back({die.name, "solid_fraction", die.loose - 0.01, die.close + 0.01, {}});
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

std::size_t columnPieces(const ValidationOptions& options) {
    return columnAspects.size() * static_cast<std::size_t>(options.repeats.value_or(columnsByDefault));
}

/// The tallest column comes first: whoever simulates it is not left alone with it at the end.
/// @return aspect, run-out, height and solid fraction of the deposit
std::vector<double> collapsedColumn(std::size_t variant, std::size_t piece, const ValidationOptions& options,
                                    const Execution& execution) {
    GrainColumn column;
    column.grain = columnGrains()[variant].sides;
    column.aspect = columnAspects[columnAspects.size() - 1 - piece % columnAspects.size()];
    column.seed = static_cast<std::uint64_t>(options.seed) + piece / columnAspects.size();
    const ColumnDeposit deposit = collapseOf(column, execution);
    return {deposit.aspect, deposit.runOut, deposit.height, deposit.solidFraction};
}

std::vector<SetFigure> columnFigures(std::size_t, const std::vector<std::vector<double>>& found) {
    std::vector<double> exponents, factors, runOuts, heights;
    for (std::size_t first = 0; first < found.size(); first += columnAspects.size()) {
        std::vector<std::pair<double, double>> points;
        for (std::size_t i = columnAspects.size(); i-- > 0;) {
            const std::vector<double>& column = found[first + i];
            points.emplace_back(column[0], column[1]);
            runOuts.push_back(column[1] / (1.6 * std::sqrt(column[0])));
            heights.push_back(column[2] / (0.88 * std::pow(column[0], 1.0 / 6.0)));
        }
        const PowerLaw law = powerLawThrough(points);
        exponents.push_back(law.exponent);
        factors.push_back(law.factor);
    }
    return {{"run_out_exponent", "", meanInterval(exponents)},
            {"run_out_factor", "", meanInterval(factors)},
            {"run_out_over_law", "", meanInterval(runOuts)},
            {"height_over_law", "", meanInterval(heights)},
            {"solid_fraction", "", meanInterval(valuesAt(found, 3))}};
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

std::size_t onePiece(const ValidationOptions&) {
    return 1;
}

std::vector<double> stood(std::size_t variant, std::size_t, const ValidationOptions&, const Execution& execution) {
    const std::size_t walls = tableWalls().size();
    return {variant < walls ? tiltingAngle(tableWalls()[variant].wall, execution)
                            : leastArchThickness(standingArches[variant - walls].arch, execution)};
}

std::vector<SetFigure> standingFigures(std::size_t variant, const std::vector<std::vector<double>>& found) {
    const double value = found.front().front();
    if (variant >= tableWalls().size()) {
        return {{"thickness_over_radius", "", {value, unknown, unknown}},
                {"limit_thickness_over_radius", "", {limitArchThickness, unknown, unknown}},
                {"over_limit", "", {value / limitArchThickness, unknown, unknown}}};
    }
    const double law = limitAngle(tableWalls()[variant].wall);
    return {{"angle_deg", "deg", {value, unknown, unknown}},
            {"limit_angle_deg", "deg", {law, unknown, unknown}},
            {"over_limit", "", {value / law, unknown, unknown}}};
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
    static const std::array sets{SceneSet{packingSet(), pours, poured, packingFigures},
                                 SceneSet{standingSet(), onePiece, stood, standingFigures},
                                 SceneSet{columnSet(), columnPieces, collapsedColumn, columnFigures}};
    return sets;
}

SetResult validateScene(const SceneSet& scene, const ValidationOptions& options, const Execution& execution) {
    SetResult result;
    result.set = &scene.about;
    for (const SetVariant& variant : scene.about.variants) {
        VariantResult one;
        one.variant = variant;
        one.used = variant.parameters;
        result.variants.push_back(std::move(one));
    }
    const std::size_t variants = result.variants.size(), pieces = scene.pieces(options);
    std::vector<std::vector<std::vector<double>>> found(variants, std::vector<std::vector<double>>(pieces));
    std::vector<double> seconds(variants * pieces);
    runInParallel(seconds.size(), {}, {"validation.scene", "simulating {0} scenes", {seconds.size()}}, execution,
                  [&](std::size_t i, const Execution& own) {
                      const auto begun = std::chrono::steady_clock::now();
                      const std::size_t variant = i % variants, piece = i / variants;
                      found[variant][piece] = scene.simulate(variant, piece, options, own);
                      seconds[i] = secondsSince(begun);
                  });
    for (std::size_t i = 0; i < seconds.size(); ++i) {
        result.variants[i % variants].seconds += seconds[i];
    }
    for (std::size_t v = 0; v < variants; ++v) {
        result.variants[v].figures = scene.figures(v, found[v]);
        judge(result.variants[v], scene.about);
    }
    return result;
}

}  // namespace rubble
