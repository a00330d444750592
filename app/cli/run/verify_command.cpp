#include "app/cli/frame/arguments.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/run_inputs.h"
#include "app/cli/frame/text_output.h"
#include "core/base/build.h"
#include "core/base/error.h"
#include "core/pipeline/pipeline.h"
#include "io/case/case_file.h"
#include "io/case/journal_check.h"
#include "io/seal/run_repeat.h"
#include "io/site/input_files.h"

namespace rubble::cli {

namespace {

/// One thing that was compared.
struct Comparison {
    std::string name;
    std::string recorded;
    std::string found;
    bool same = false;
    std::string said{};  ///< in place of what was found; empty: that says it
};

Comparison compare(std::string name, std::string recorded, std::string found) {
    const bool same = recorded == found;
    return {std::move(name), std::move(recorded), std::move(found), same};
}

ExitCode report(const Arguments& arguments, Session& session, const std::vector<Comparison>& checks, const std::string& verdict,
                const std::string& note, bool good) {
    if (arguments.json()) {
        Json object;
        object["file"] = arguments.operand();
        object["verdict"] = verdict;
        object["ok"] = good;
        object["checks"] = Json::array();
        for (const Comparison& check : checks) {
            object["checks"].push_back(
                {{"name", check.name}, {"same", check.same}, {"recorded", check.recorded}, {"found", check.found}});
        }
        object["note"] = note;
        printJson(session, object);
    } else {
        FactList facts;
        for (const Comparison& check : checks) {
            facts.add(check.name, !check.said.empty() ? check.said
                                  : check.same        ? "same: " + check.found
                                                      : "differs: recorded " + check.recorded + ", now " + check.found);
        }
        session.out() << arguments.operand() << ": " << verdict << '\n';
        facts.print(session.out());
        if (!note.empty()) {
            session.out() << "  " << note << '\n';
        }
    }
    return good ? ExitCode::Ok : ExitCode::Failed;
}

std::string orNothing(const std::string& value) {
    return value.empty() ? "nothing" : value;
}

/// What the journal of a case says of it: its chain, and each place that is not as it was saved.
void addJournal(std::vector<Comparison>& checks, const io::JournalCheck& journal) {
    const std::string whole = "entries chained: " + englishInteger(static_cast<std::int64_t>(journal.entries));
    Comparison chain = compare("journal", whole, whole);
    if (journal.entries == 0) {
        chain.found = chain.recorded = "none";
        chain.said = !journal.broken.empty() ? "" : "none, so it cannot be told whether the case itself was altered";
    }
    for (const std::size_t number : journal.broken) {
        chain.same = false;
        chain.found = (chain.found == whole ? "altered or missing before: entry " : chain.found + ", ") +
                      englishInteger(static_cast<std::int64_t>(number));
    }
    checks.push_back(std::move(chain));
    for (const JournalChange& change : journal.altered) {
        checks.push_back({change.place, orNothing(change.before), orNothing(change.after), false});
    }
}

/// Alterations of before that came into the journal when the case was saved again, and clocks that were set back.
std::string journalNote(const io::JournalCheck& journal) {
    std::string places;
    for (const JournalEntry& entry : journal.outside) {
        for (const JournalChange& change : entry.changes) {
            places += (places.empty() ? "" : ", ") + change.place;
        }
    }
    std::string note = places.empty() ? "" : "Altered outside Rubble before it was last saved: " + places + ".";
    for (const std::size_t number : journal.backward) {
        note += (note.empty() ? "Entry " : " Entry ") + englishInteger(static_cast<std::int64_t>(number)) +
                " of the journal is of a time before that of an earlier one.";
    }
    return note;
}

ExitCode verifyCase(const Arguments& arguments, Session& session) {
    const Case theCase = io::loadCase(arguments.operand());
    std::vector<Comparison> checks;
    bool good = true;
    for (const CaseInput& input : theCase.inputs) {
        session.execution().check();
        Comparison check;
        try {
            const std::string path = io::inputPath(arguments.operand(), input);
            check = compare(input.id + " " + input.path, input.sha256,
                            io::digestOfInput(path, input.role, session.execution()).against(input.sha256));
        } catch (const WorldError& error) {
            check = {input.id + " " + input.path, input.sha256, englishText(error.message()), false};
        }
        good = good && check.same;
        checks.push_back(std::move(check));
    }
    const io::JournalCheck journal = io::checkJournal(arguments.operand());
    addJournal(checks, journal);
    const std::string verdict = !good                      ? "inputs differ"
                                : !journal.broken.empty()  ? "the journal was altered"
                                : !journal.altered.empty() ? "the case was altered outside Rubble"
                                                           : "inputs unchanged";
    return report(arguments, session, checks, verdict, journalNote(journal), good && journal.sound());
}

ExitCode verifyRun(const Arguments& arguments, Session& session) {
    const std::string& path = arguments.operand();
    const std::shared_ptr<io::RunReader> recorded = io::openRun(path);
    if (!recorded->complete()) {
        throw ParseError({"cli.run_incomplete",
                          "{0} is not complete: it holds {1} frames and no outcome to compare with.",
                          {path, recorded->frameCount()}},
                         {"cli.run_incomplete.remedy", "What it holds can be shown and exported; simulate again to verify.", {}});
    }
    io::checkRunDigest(path, session.execution());
    const Inputs inputs = openInputsOfRun(recorded->origin(), arguments, session);
    const io::RunRepeat repeat = io::repeatRun(*recorded, inputs, session.execution());
    std::vector<Comparison> checks;
    for (const io::RepeatedFigure& figure : repeat.figures) {
        checks.push_back(compare(figure.name, figure.recorded, figure.found));
    }
    return report(arguments, session, checks, repeat.equal ? "bit-equal" : "not equal", englishText(repeat.firstDifference),
                  repeat.equal);
}

ExitCode verify(const Arguments& arguments, Session& session) {
    return io::isCaseFile(arguments.operand()) ? verifyCase(arguments, session) : verifyRun(arguments, session);
}

}  // namespace

Command verifyCommand() {
    return {"verify",
            "RUN|CASE",
            "does a run repeat bit by bit; are a case and its inputs unchanged",
            "RUN: checks the digest of the whole file, then simulates again and compares. CASE: compares the SHA-256 of its "
            "inputs, and "
            "holds what it says against its journal, whose entries are chained by their digests.",
            {feOption(), runTerrainOption()},
            verify};
}

}  // namespace rubble::cli
