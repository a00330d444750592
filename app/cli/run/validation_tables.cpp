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

TextTable quantityTable(const VariantRecord& variant) {
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
    for (const QuantityRecord& quantity : variant.quantities) {
        const SampleComparison& c = quantity.comparison;
        table.add({textCell(quantity.title), textCell(quantity.unit), integerCell(static_cast<std::int64_t>(c.measured.count)),
                   textCell(meanText(c.measured)), textCell(meanText(c.simulated)), textCell(intervalText(c.error)),
                   textCell(intervalText(c.scatterRatio)), numberCell(c.area), numberCell(c.areaByChance), integerCell(c.lost)});
    }
    return table;
}

TextTable figureTable(const VariantRecord& variant) {
    TextTable table({{"figure", "figure"}, {"unit", "unit"}, {"value, 95 %", "value"}});
    for (const SetFigure& figure : variant.otherFigures()) {
        table.add({textCell(figure.key), textCell(figure.unit), textCell(intervalText(figure.value))});
    }
    return table;
}

void printVariant(std::ostream& out, const VariantRecord& variant) {
    out << '\n' << variant.name << ": " << variant.words << '\n';
    for (const SetParameter& parameter : variant.parameters) {
        out << "  " << parameter.key << " = " << parameter.value << "  (" << parameter.source << ")\n";
    }
    if (variant.bodies > 0) {
        out << "  " << variant.bodies << " bodies, " << variant.falls << " falls; " << variant.moving << " still moving, "
            << variant.left << " left the terrain, " << variant.lost << " lost; " << englishNumber(variant.seconds) << " s\n"
            << "  " << englishNumber(variant.stepRate) << " steps a second: " << variant.stepRateReason << '\n';
        quantityTable(variant).print(out);
    }
    const TextTable figures = figureTable(variant);
    if (figures.rows() > 0) {
        figures.print(out);
    }
    for (const VerdictRecord& verdict : variant.verdicts) {
        out << (verdict.within ? "  within   " : "  OUTSIDE  ") << verdict.figure << " = " << englishNumber(verdict.value)
            << ", asked: " << verdict.asked << '\n';
    }
}

}  // namespace

void printValidation(std::ostream& out, const ValidationRecord& record, const Findings& findings) {
    printHeading(out, record.id + ": " + record.title);
    out << "source: " << record.source << "\nlicence: " << record.licence << '\n';
    if (!record.folder.empty()) {
        out << "folder: " << record.folder << '\n';
    }
    for (const VariantRecord& variant : record.variants) {
        printVariant(out, variant);
    }
    printFindings(out, findings);
}

TextTable validationTable(const std::vector<ValidationRecord>& records) {
    TextTable table({{"set", "set"},
                     {"variant", "variant"},
                     {"figure", "figure"},
                     {"unit", "unit"},
                     {"value", "value"},
                     {"low", "low"},
                     {"high", "high"}});
    for (const ValidationRecord& record : records) {
        for (const VariantRecord& variant : record.variants) {
            for (const SetFigure& figure : variant.figures) {
                table.add({textCell(record.id), textCell(variant.name), textCell(figure.key), textCell(figure.unit),
                           numberCell(figure.value.value), numberCell(figure.value.low), numberCell(figure.value.high)});
            }
        }
    }
    return table;
}

}  // namespace rubble::cli
