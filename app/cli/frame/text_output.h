#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <string>

#include "app/cli/frame/session.h"
#include "app/cli/frame/text_table.h"
#include "core/base/finding.h"
#include "core/pipeline/pipeline.h"

namespace rubble::cli {

/// A heading over a table or list.
void printHeading(std::ostream& out, const std::string& heading);

/// "name    value" rows with the values in one column.
class FactList {
public:
    void add(std::string name, std::string value) { m_rows.emplace_back(std::move(name), std::move(value)); }
    void print(std::ostream& out) const;

private:
    std::vector<std::pair<std::string, std::string>> m_rows;
};

/// Findings of what a command stands on but does not list, as notes on the stream of errors.
void printNotes(Session& session, const Findings& findings);

/// How a message is said.
using Saying = std::function<std::string(const Message&)>;

/// Every finding with its count, example and remedy; says so if there is none.
void printFindings(std::ostream& out, const Findings& findings);
/// Words of a list of findings.
struct FindingWords {
    Message heading{"cli.findings", "Findings", {}};
    Message example{"cli.finding_example", "for example", {}};
    Message remedy{"cli.finding_remedy", "remedy", {}};
};
/// The same in other words or another language.
void printFindings(std::ostream& out, const Findings& findings, const FindingWords& words, const Saying& say);

/// Bounds of the Basic Grid, one row for each axis.
TextTable boundsTable(const Sizing& sizing, const FragmentSet& fragments, const Components& components, const Mesh& mesh);

/// The search in words: what was counted and what stopped it.
/// @param caution  what its bodies and its frame rate leave out; unset: nothing
void printSizing(std::ostream& out, const Sizing& sizing, const FragmentSet& fragments, const Components& components,
                 const Mesh& mesh, const std::optional<Finding>& caution);

/// "1 limit", "2 limits".
std::string counted(std::int64_t number, const char* one, const char* many);

/// "1.23 ± 0.05", as far as the spread deserves.
std::string spreadText(double number, double spread);

/// "12,345.6 t" and the like, from kg.
std::string tonnesText(double kilograms);

}  // namespace rubble::cli
