#include "core/validation/validation_record.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

std::string askedText(const SetVerdict& verdict) {
    const SetCriterion& asked = verdict.criterion;
    std::string text;
    const auto add = [&](const std::string& words) { text += (text.empty() ? "" : ", ") + words; };
    if (std::isfinite(asked.low)) {
        add("at least " + englishNumber(asked.low));
    }
    if (std::isfinite(asked.high)) {
        add("at most " + englishNumber(asked.high));
    }
    if (!asked.below.empty()) {
        add("below " + asked.below + " " + englishNumber(verdict.limit));
    }
    return text;
}

VariantRecord variantRecord(const VariantResult& variant) {
    VariantRecord record;
    record.name = variant.variant.name;
    record.words = variant.variant.words;
    record.parameters = variant.used;
    record.fitted = !variant.variant.fitted.empty();
    record.bodies = variant.bodies;
    record.falls = variant.simulated;
    record.moving = variant.moving;
    record.left = variant.left;
    record.lost = variant.lost;
    record.stepRate = variant.stepRate;
    record.stepRateReason = englishText(variant.stepRateReason);
    for (const QuantityComparison& quantity : variant.quantities) {
        record.quantities.push_back({quantity.key, quantity.title, quantity.unit, quantity.comparison});
    }
    record.figures = variant.figures;
    for (const SetVerdict& verdict : variant.verdicts) {
        record.verdicts.push_back({verdict.criterion.figure, verdict.value, askedText(verdict), verdict.within});
    }
    record.seconds = variant.seconds;
    return record;
}

}  // namespace

std::vector<SetFigure> VariantRecord::otherFigures() const {
    std::vector<SetFigure> others;
    for (const SetFigure& figure : figures) {
        const bool ofQuantity = std::any_of(quantities.begin(), quantities.end(), [&](const QuantityRecord& quantity) {
            return figure.key.starts_with(quantity.key + ".");
        });
        if (!ofQuantity) {
            others.push_back(figure);
        }
    }
    return others;
}

ValidationRecord recordOf(const SetResult& result) {
    const ValidationSet& set = *result.set;
    ValidationRecord record{set.id, set.title, set.source, set.licence, set.folder, set.bodies.size(), {}};
    for (const VariantResult& variant : result.variants) {
        record.variants.push_back(variantRecord(variant));
    }
    return record;
}

}  // namespace rubble
