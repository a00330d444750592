#include "app/cli/run/effects_output.h"

#include <cmath>

#include "app/cli/frame/text_output.h"

namespace rubble::cli {

namespace {

/// A cost below this share of the step is not worth a number.
constexpr double smallShare = 0.01;
/// Columns of a terminal that reasons are broken to.
constexpr std::size_t lineWidth = 118;

std::string_view switchName(EffectSwitch state) {
    static constexpr std::array<std::string_view, 3> names{"off", "on", "auto"};
    return names[static_cast<std::size_t>(state)];
}

Json decisionJson(const EffectDecision& decision) {
    Json row;
    row["effect"] = effectName(decision.kind);
    row["asked"] = switchName(decision.asked);
    row["state"] = decision.on ? "on" : "off";
    row["reason"] = englishText(decision.reason);
    row["measure"] = decision.measure;
    row["threshold"] = decision.threshold;
    return row;
}

/// Text broken between words, each line behind so many blanks.
void printBroken(std::ostream& out, const std::string& text, std::size_t indent) {
    std::size_t column = lineWidth;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        if (column + 1 + end - at > lineWidth) {
            out << (at > 0 ? "\n" : "") << std::string(indent, ' ');
            column = indent;
        } else {
            out << ' ';
            ++column;
        }
        out << text.substr(at, end - at);
        column += end - at;
        at = end + 1;
    }
    out << '\n';
}

void printReasons(std::ostream& out, std::span<const EffectDecision> decisions) {
    for (const EffectDecision& decision : decisions) {
        out << "  " << effectName(decision.kind) << " is " << (decision.on ? "on" : "off") << ":\n";
        printBroken(out, englishText(decision.reason), 6);
    }
}

}  // namespace

Json effectsJson(const EffectDecisions& decisions) {
    Json list = Json::array();
    for (const EffectDecision& decision : decisions) {
        list.push_back(decisionJson(decision));
    }
    return list;
}

Json effectsJson(const std::vector<EffectReport>& reports) {
    Json list = Json::array();
    for (const EffectReport& report : reports) {
        Json row = decisionJson(report.decision);
        row["ms_per_step"] = report.msPerStep;
        row["share"] = report.share;
        row["work_j"] = report.work;
        row["events"] = report.events;
        list.push_back(std::move(row));
    }
    return list;
}

Json costsJson(const SimulationResult& run) {
    const StepTimes& times = run.stepTimes;
    const double sum = accountedMs(run);
    return {{"effects", sum - times.restMs()}, {"motion", times.motionMs},
            {"substep_hook", times.hookMs},    {"bookkeeping", times.bookkeepingMs},
            {"health", times.healthMs},        {"sum", sum},
            {"measured", times.allMs},         {"difference_percent", 100.0 * accountError(run)},
            {"recording", times.recordingMs},  {"births", times.birthsMs}};
}

TextTable effectsTable(const EffectDecisions& decisions) {
    TextTable table({{"effect", "effect"},
                     {"asked", "asked"},
                     {"state", "state"},
                     {"reason", "reason"},
                     {"measure", "measure"},
                     {"threshold", "threshold"}});
    for (const EffectDecision& decision : decisions) {
        table.add({textCell(std::string(effectName(decision.kind))), textCell(std::string(switchName(decision.asked))),
                   textCell(decision.on ? "on" : "off"), textCell(englishText(decision.reason)), numberCell(decision.measure),
                   numberCell(decision.threshold)});
    }
    return table;
}

void printEffects(std::ostream& out, const EffectDecisions& decisions) {
    printHeading(out, "Effects");
    TextTable table({{"effect", ""}, {"asked", ""}, {"state", ""}});
    for (const EffectDecision& decision : decisions) {
        table.add({textCell(std::string(effectName(decision.kind))), textCell(std::string(switchName(decision.asked))),
                   textCell(decision.on ? "on" : "off")});
    }
    table.print(out);
    printReasons(out, decisions);
}

void printEffects(std::ostream& out, const SimulationResult& run) {
    printHeading(out, "Effects");
    TextTable table(
        {{"effect", ""}, {"asked", ""}, {"state", ""}, {"ms per step", ""}, {"share", ""}, {"work [J]", ""}, {"events", ""}});
    std::vector<EffectDecision> decisions;
    const auto share = [](double part) {
        return textCell(part < smallShare ? "< 1 %" : englishNumber(std::round(1000.0 * part) / 10.0) + " %");
    };
    for (const EffectReport& report : run.effects) {
        const EffectDecision& decision = decisions.emplace_back(report.decision);
        std::vector<Cell> row{textCell(std::string(effectName(decision.kind))), textCell(std::string(switchName(decision.asked))),
                              textCell(decision.on ? "on" : "off")};
        if (decision.on) {
            row.insert(row.end(),
                       {numberCell(report.msPerStep), share(report.share), numberCell(report.work), integerCell(report.events)});
        } else {
            row.resize(7, textCell(""));
        }
        table.add(std::move(row));
    }
    const StepTimes& times = run.stepTimes;
    const auto addRest = [&](const std::string& name, double ms) {
        table.add(
            {textCell(name), textCell(""), textCell(""), numberCell(ms), share(ms / times.allMs), textCell(""), textCell("")});
    };
    if (times.allMs > 0.0) {
        addRest("motion, freezing", times.motionMs);
        addRest("substep hook", times.hookMs);
        addRest("bookkeeping", times.bookkeepingMs);
        addRest("health monitor", times.healthMs);
        addRest("sum", accountedMs(run));
        addRest("measured step", times.allMs);
    }
    table.print(out);
    if (times.allMs > 0.0) {
        out << "  the sum differs from the measured step by "
            << englishNumber(std::round(1000.0 * std::abs(accountError(run))) / 10.0)
            << " %; between the steps, per step: recording " << englishNumber(times.recordingMs) << " ms, births and ledger "
            << englishNumber(times.birthsMs) << " ms\n";
    }
    printReasons(out, decisions);
}

}  // namespace rubble::cli
