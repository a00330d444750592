#include "io/validation/validation_json.h"

#include <nlohmann/json.hpp>

#include "core/base/unknown.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

namespace {

double numberFrom(const JsonCursor& cursor) {
    return cursor.value().is_null() ? unknown : cursor.number();
}

JsonValue intervalJson(const ConfidenceInterval& interval) {
    return {{"value", interval.value}, {"low", interval.low}, {"high", interval.high}};
}

ConfidenceInterval intervalFrom(const JsonCursor& cursor) {
    return {numberFrom(cursor["value"]), numberFrom(cursor["low"]), numberFrom(cursor["high"])};
}

JsonValue sampleJson(const MeanAndScatter& sample) {
    return {{"count", sample.count}, {"mean", sample.mean}, {"deviation", sample.scatter}};
}

MeanAndScatter sampleFrom(const JsonCursor& cursor) {
    return {static_cast<std::size_t>(cursor["count"].integer()), numberFrom(cursor["mean"]), numberFrom(cursor["deviation"])};
}

JsonValue quantityJson(const QuantityRecord& quantity) {
    const SampleComparison& c = quantity.comparison;
    return {{"key", quantity.key},
            {"title", quantity.title},
            {"unit", quantity.unit},
            {"measured", sampleJson(c.measured)},
            {"simulated", sampleJson(c.simulated)},
            {"error", intervalJson(c.error)},
            {"uncertainty", c.uncertainty},
            {"scatter_ratio", intervalJson(c.scatterRatio)},
            {"area", c.area},
            {"area_by_chance", c.areaByChance},
            {"not_known", c.lost}};
}

QuantityRecord quantityFrom(const JsonCursor& cursor) {
    QuantityRecord quantity{cursor["key"].text(), cursor["title"].text(), cursor["unit"].text(), {}};
    SampleComparison& c = quantity.comparison;
    c.measured = sampleFrom(cursor["measured"]);
    c.simulated = sampleFrom(cursor["simulated"]);
    c.error = intervalFrom(cursor["error"]);
    c.uncertainty = numberFrom(cursor["uncertainty"]);
    c.scatterRatio = intervalFrom(cursor["scatter_ratio"]);
    c.area = numberFrom(cursor["area"]);
    c.areaByChance = numberFrom(cursor["area_by_chance"]);
    c.lost = cursor["not_known"].integer();
    return quantity;
}

JsonValue variantJson(const VariantRecord& variant) {
    JsonValue object;
    object["name"] = variant.name;
    object["words"] = variant.words;
    object["parameters"] = JsonValue::array();
    for (const SetParameter& parameter : variant.parameters) {
        object["parameters"].push_back({{"key", parameter.key}, {"value", parameter.value}, {"source", parameter.source}});
    }
    object["fitted"] = variant.fitted;
    object["bodies"] = variant.bodies;
    object["falls"] = variant.falls;
    object["moving"] = variant.moving;
    object["left"] = variant.left;
    object["lost"] = variant.lost;
    object["step_rate"] = variant.stepRate;
    object["step_rate_reason"] = variant.stepRateReason;
    object["quantities"] = JsonValue::array();
    for (const QuantityRecord& quantity : variant.quantities) {
        object["quantities"].push_back(quantityJson(quantity));
    }
    object["figures"] = JsonValue::array();
    for (const SetFigure& figure : variant.figures) {
        JsonValue row = intervalJson(figure.value);
        row["key"] = figure.key;
        row["unit"] = figure.unit;
        object["figures"].push_back(std::move(row));
    }
    object["criteria"] = JsonValue::array();
    for (const VerdictRecord& verdict : variant.verdicts) {
        object["criteria"].push_back(
            {{"figure", verdict.figure}, {"value", verdict.value}, {"asked", verdict.asked}, {"within", verdict.within}});
    }
    object["wall_s"] = variant.seconds;
    return object;
}

VariantRecord variantFrom(const JsonCursor& cursor) {
    VariantRecord variant;
    variant.name = cursor["name"].text();
    variant.words = cursor["words"].text();
    variant.fitted = cursor["fitted"].flag();
    variant.bodies = cursor["bodies"].integer();
    variant.falls = cursor["falls"].integer();
    variant.moving = cursor["moving"].integer();
    variant.left = cursor["left"].integer();
    variant.lost = cursor["lost"].integer();
    variant.stepRate = numberFrom(cursor["step_rate"]);
    variant.stepRateReason = cursor["step_rate_reason"].text();
    variant.seconds = numberFrom(cursor["wall_s"]);
    for (const JsonCursor& each : cursor["parameters"].elements()) {
        variant.parameters.push_back({each["key"].text(), each["value"].text(), each["source"].text()});
    }
    for (const JsonCursor& each : cursor["quantities"].elements()) {
        variant.quantities.push_back(quantityFrom(each));
    }
    for (const JsonCursor& each : cursor["figures"].elements()) {
        variant.figures.push_back({each["key"].text(), each["unit"].text(), intervalFrom(each)});
    }
    for (const JsonCursor& each : cursor["criteria"].elements()) {
        variant.verdicts.push_back({each["figure"].text(), numberFrom(each["value"]), each["asked"].text(), each["within"].flag()});
    }
    return variant;
}

}  // namespace

JsonValue validationJson(const ValidationRecord& record) {
    JsonValue object;
    object["id"] = record.id;
    object["title"] = record.title;
    object["source"] = record.source;
    object["licence"] = record.licence;
    object["folder"] = record.folder;
    object["bodies"] = record.bodies;
    object["variants"] = JsonValue::array();
    for (const VariantRecord& variant : record.variants) {
        object["variants"].push_back(variantJson(variant));
    }
    return object;
}

ValidationRecord validationFromText(const std::string& text, const std::string& file) {
    const nlohmann::json document = parseJson(text, file);
    const JsonCursor cursor(document, file);
    ValidationRecord record{cursor["id"].text(),
                            cursor["title"].text(),
                            cursor["source"].text(),
                            cursor["licence"].text(),
                            cursor["folder"].text(),
                            static_cast<std::size_t>(cursor["bodies"].integer()),
                            {}};
    for (const JsonCursor& each : cursor["variants"].elements()) {
        record.variants.push_back(variantFrom(each));
    }
    return record;
}

}  // namespace rubble::io
