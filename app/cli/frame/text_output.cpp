#include "app/cli/frame/text_output.h"

#include <algorithm>
#include <array>

#include "core/base/message.h"
#include "core/evidence/photographs/confidence.h"

namespace rubble::cli {

void printHeading(std::ostream& out, const std::string& heading) {
    out << '\n' << heading << '\n';
}

void FactList::print(std::ostream& out) const {
    std::size_t widest = 0;
    for (const auto& [name, value] : m_rows) {
        widest = std::max(widest, name.size());
    }
    for (const auto& [name, value] : m_rows) {
        out << "  " << name << std::string(widest - name.size() + 2, ' ') << value << '\n';
    }
}

void printNotes(Session& session, const Findings& findings) {
    for (const Finding& finding : findings.list()) {
        const std::string what = englishText(finding.what);
        const bool named = finding.example.empty() || what.find(finding.example) != std::string::npos;
        session.err() << "rubble-cli: note: " << (named ? "" : finding.example + ": ") << what << "\n  "
                      << englishText(finding.remedy) << '\n';
    }
}

void printFindings(std::ostream& out, const Findings& findings) {
    if (findings.empty()) {
        out << "\nNo findings.\n";
        return;
    }
    printFindings(out, findings, {}, englishText);
}

void printFindings(std::ostream& out, const Findings& findings, const FindingWords& words, const Saying& say) {
    printHeading(out, say(words.heading));
    for (const Finding& finding : findings.list()) {
        out << "  " << englishInteger(finding.count) << " x  " << say(finding.what) << " [" << finding.what.id << "]\n";
        if (!finding.example.empty()) {
            out << "        " << say(words.example) << ": " << finding.example << '\n';
        }
        if (!finding.remedy.empty()) {
            out << "        " << say(words.remedy) << ": " << say(finding.remedy) << '\n';
        }
    }
}

TextTable boundsTable(const Sizing& sizing, const FragmentSet& fragments, const Components& components, const Mesh& mesh) {
    TextTable table({{"axis", "axis"},
                     {"d [m]", "mean_distance_m"},
                     {"h_eff_min [m]", "h_eff_min_m"},
                     {"h_acc_min [m]", "h_acc_min_m"},
                     {"h_acc_max [m]", "h_acc_max_m"},
                     {"size [m]", "size_m"},
                     {"multiple", "multiple"},
                     {"clamped by", "clamped_by"},
                     {"largest fragment", "largest_fragment_element"},
                     {"smallest component", "smallest_component"}});
    constexpr std::array<const char*, 3> names{"x (l)", "y (w)", "z (h)"};
    for (std::size_t i = 0; i < 3; ++i) {
        const AxisSizing& axis = sizing.axis[i];
        Cell largest = textCell("-");
        if (axis.largestFragment) {
            const std::int64_t element = mesh.elementIds[at(fragments.list[at(*axis.largestFragment)].element)];
            largest = {"element " + englishInteger(element), std::to_string(element), false};
        }
        table.add({textCell(names[i]), numberCell(axis.meanDistance), numberCell(axis.efficiencyMin), numberCell(axis.accuracyMin),
                   numberCell(axis.accuracyMax), numberCell(axis.size), numberCell(axis.multiple),
                   textCell(std::string(clampedByName(axis.clampedBy))), largest,
                   textCell(axis.smallestComponent ? components.list[at(*axis.smallestComponent)].name : "-")});
    }
    return table;
}

namespace {

std::string stoppedText(const Sizing& sizing) {
    std::string count = englishInteger(static_cast<std::int64_t>(sizing.clusters)) + " clusters";
    if (sizing.awake < sizing.clusters) {
        count += " (" + englishInteger(static_cast<std::int64_t>(sizing.awake)) + " of them awake at once)";
    }
    const std::string limit = englishInteger(sizing.bodiesMax);
    const std::string target = englishNumber(sizing.fpsTarget) + " FPS";
    switch (sizing.stoppedBy) {
        case StoppedBy::Efficiency:
            return "efficiency: " + count + " are within the " + limit + " bodies that " + target + " allow";
        case StoppedBy::FpsUnreachable:
            return "fps_unreachable: at the upper bounds " + count + " are left, " + limit + " bodies are allowed for " + target +
                   "; about " + englishNumber(sizing.reachableFps) + " FPS are within reach";
        case StoppedBy::User:
            return "user: the size was set by hand; " + count + ", " + limit + " bodies are allowed for " + target;
    }
    return {};
}

}  // namespace

void printSizing(std::ostream& out, const Sizing& sizing, const FragmentSet& fragments, const Components& components,
                 const Mesh& mesh, const std::optional<Finding>& caution) {
    printHeading(out, "Basic Grid");
    boundsTable(sizing, fragments, components, mesh).print(out);
    FactList facts;
    facts.add("fragments", englishInteger(static_cast<std::int64_t>(sizing.fragments)));
    facts.add("clusters", englishInteger(static_cast<std::int64_t>(sizing.clusters)));
    facts.add("grid l, w, h",
              englishNumber(sizing.grid.l) + ", " + englishNumber(sizing.grid.w) + ", " + englishNumber(sizing.grid.h) + " m");
    facts.add("common multiple", englishNumber(sizing.commonMultiple) + " d");
    facts.add("stopped by", stoppedText(sizing));
    if (caution) {
        facts.add("but", englishText(caution->what));
        facts.add("remedy", englishText(caution->remedy));
    }
    facts.print(out);
}

std::string counted(std::int64_t number, const char* one, const char* many) {
    return englishInteger(number) + ' ' + (number == 1 ? one : many);
}

std::string spreadText(double number, double spread) {
    const auto [shown, off] = roundedToSpread(number, spread);
    return englishNumber(shown) + " ± " + englishNumber(off);
}

std::string tonnesText(double kilograms) {
    return englishNumber(kilograms / 1000.0) + " t";
}

}  // namespace rubble::cli
