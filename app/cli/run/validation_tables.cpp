#include "app/cli/run/validation_tables.h"

#include <cmath>

#include "app/cli/frame/text_output.h"

namespace rubble::cli {

namespace {

std::string intervalText(const ConfidenceInterval& interval) {
    if (!std::isfinite(interval.low) || !std::isfinite(interval.high)) {
        return englishNumber(interval.value);
    }
    return englishNumber(interval.value) + " (" + englishNumber(interval.low) + " to " + englishNumber(interval.high) + ")";
}

std::string meanText(const MeanAndScatter& sample) {
    return spreadText(sample.mean, sample.scatter);
}

TextTable quantityTable(const VariantResult& variant) {
    TextTable table({{"quantity", "quantity"},
                     {"unit", "unit"},
                     {"n", "n"},
                     {"measured D", "measured"},
                     {"simulated S", "simulated"},
                     {"E = S - D, 95 %", "error"},
                     {"scatter S/D, 95 %", "scatter_ratio"},
                     {"area", "area"},
                     {"by chance", "area_by_chance"},
                     {"not known", "lost"}});
    for (const QuantityComparison& quantity : variant.quantities) {
        const SampleComparison& c = quantity.comparison;
        table.add({textCell(quantity.title), textCell(quantity.unit), integerCell(static_cast<std::int64_t>(c.measured.count)),
                   textCell(meanText(c.measured)), textCell(meanText(c.simulated)), textCell(intervalText(c.error)),
                   textCell(intervalText(c.scatterRatio)), numberCell(c.area), numberCell(c.areaByChance), integerCell(c.lost)});
    }
    return table;
}

bool ofQuantity(const VariantResult& variant, const SetFigure& figure) {
    for (const QuantityComparison& quantity : variant.quantities) {
        if (figure.key.starts_with(quantity.key + ".")) {
            return true;
        }
    }
    return false;
}

TextTable figureTable(const VariantResult& variant) {
    TextTable table({{"figure", "figure"}, {"unit", "unit"}, {"value, 95 %", "value"}});
    for (const SetFigure& figure : variant.figures) {
        if (!ofQuantity(variant, figure)) {
            table.add({textCell(figure.key), textCell(figure.unit), textCell(intervalText(figure.value))});
        }
    }
    return table;
}

std::string askedText(const SetVerdict& verdict) {
    const SetCriterion& asked = verdict.criterion;
    std::string text;
    if (std::isfinite(asked.low)) {
        text = "at least " + englishNumber(asked.low);
    }
    if (std::isfinite(asked.high)) {
        text += (text.empty() ? "at most " : ", at most ") + englishNumber(asked.high);
    }
    if (!asked.below.empty()) {
        text += (text.empty() ? "below " : ", below ") + asked.below + " " + englishNumber(verdict.limit);
    }
    return text;
}

void printVariant(std::ostream& out, const VariantResult& variant) {
    out << '\n' << variant.variant.name << ": " << variant.variant.words << '\n';
    for (const SetParameter& parameter : variant.used) {
        out << "  " << parameter.key << " = " << parameter.value << "  (" << parameter.source << ")\n";
    }
    if (variant.bodies > 0) {
        out << "  " << variant.bodies << " bodies, " << variant.simulated << " falls; " << variant.moving << " still moving, "
            << variant.left << " left the terrain, " << variant.lost << " lost; " << englishNumber(variant.seconds) << " s\n"
            << "  " << englishNumber(variant.stepRate) << " steps a second: " << englishText(variant.stepRateReason) << '\n';
        quantityTable(variant).print(out);
    }
    const TextTable figures = figureTable(variant);
    if (figures.rows() > 0) {
        figures.print(out);
    }
    for (const SetVerdict& verdict : variant.verdicts) {
        out << (verdict.within ? "  within   " : "  OUTSIDE  ") << verdict.criterion.figure << " = " << englishNumber(verdict.value)
            << ", asked: " << askedText(verdict) << '\n';
    }
}

Json intervalJson(const ConfidenceInterval& interval) {
    return Json{{"value", interval.value}, {"low", interval.low}, {"high", interval.high}};
}

Json quantityJson(const QuantityComparison& quantity) {
    const SampleComparison& c = quantity.comparison;
    Json object;
    object["key"] = quantity.key;
    object["unit"] = quantity.unit;
    object["measured"] = Json{{"count", c.measured.count}, {"mean", c.measured.mean}, {"deviation", c.measured.scatter}};
    object["simulated"] = Json{{"count", c.simulated.count}, {"mean", c.simulated.mean}, {"deviation", c.simulated.scatter}};
    object["error"] = intervalJson(c.error);
    object["uncertainty"] = c.uncertainty;
    object["scatter_ratio"] = intervalJson(c.scatterRatio);
    object["area"] = c.area;
    object["area_by_chance"] = c.areaByChance;
    object["not_known"] = c.lost;
    return object;
}

Json variantJson(const VariantResult& variant) {
    Json object;
    object["name"] = variant.variant.name;
    object["words"] = variant.variant.words;
    object["parameters"] = Json::array();
    for (const SetParameter& parameter : variant.used) {
        object["parameters"].push_back({{"key", parameter.key}, {"value", parameter.value}, {"source", parameter.source}});
    }
    object["fitted"] = !variant.variant.fitted.empty();
    object["bodies"] = variant.bodies;
    object["falls"] = variant.simulated;
    object["moving"] = variant.moving;
    object["left"] = variant.left;
    object["lost"] = variant.lost;
    object["step_rate"] = variant.stepRate;
    object["step_rate_reason"] = englishText(variant.stepRateReason);
    object["quantities"] = Json::array();
    for (const QuantityComparison& quantity : variant.quantities) {
        object["quantities"].push_back(quantityJson(quantity));
    }
    object["figures"] = Json::array();
    for (const SetFigure& figure : variant.figures) {
        Json row = intervalJson(figure.value);
        row["key"] = figure.key;
        row["unit"] = figure.unit;
        object["figures"].push_back(std::move(row));
    }
    object["criteria"] = Json::array();
    for (const SetVerdict& verdict : variant.verdicts) {
        object["criteria"].push_back({{"figure", verdict.criterion.figure},
                                      {"value", verdict.value},
                                      {"asked", askedText(verdict)},
                                      {"within", verdict.within}});
    }
    object["wall_s"] = variant.seconds;
    return object;
}

}  // namespace

void printValidation(std::ostream& out, const SetResult& result) {
    printHeading(out, result.set->id + ": " + result.set->title);
    out << "source: " << result.set->source << "\nlicence: " << result.set->licence << '\n';
    if (!result.set->folder.empty()) {
        out << "folder: " << result.set->folder << '\n';
    }
    for (const VariantResult& variant : result.variants) {
        printVariant(out, variant);
    }
    printFindings(out, result.findings);
}

TextTable validationTable(const std::vector<SetResult>& results) {
    TextTable table({{"set", "set"},
                     {"variant", "variant"},
                     {"figure", "figure"},
                     {"unit", "unit"},
                     {"value", "value"},
                     {"low", "low"},
                     {"high", "high"}});
    for (const SetResult& result : results) {
        for (const VariantResult& variant : result.variants) {
            for (const SetFigure& figure : variant.figures) {
                table.add({textCell(result.set->id), textCell(variant.variant.name), textCell(figure.key), textCell(figure.unit),
                           numberCell(figure.value.value), numberCell(figure.value.low), numberCell(figure.value.high)});
            }
        }
    }
    return table;
}

Json validationJson(const SetResult& result) {
    Json object;
    object["id"] = result.set->id;
    object["title"] = result.set->title;
    object["source"] = result.set->source;
    object["licence"] = result.set->licence;
    object["folder"] = result.set->folder;
    object["bodies"] = result.set->bodies.size();
    object["variants"] = Json::array();
    for (const VariantResult& variant : result.variants) {
        object["variants"].push_back(variantJson(variant));
    }
    object["warnings"] = findingsJson(result.findings);
    return object;
}

}  // namespace rubble::cli
