#include "app/cli/command_line.h"

#include <algorithm>

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/interruption.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/progress_line.h"
#include "app/cli/frame/session.h"
#include "app/cli/self_description.h"
#include "core/base/build.h"
#include "core/base/error.h"

namespace rubble::cli {

namespace {

constexpr std::string_view exitCodesText = "Exit codes: 0 ok, 1 failed, 2 wrong usage, 3 cancelled.\n";

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size() + 1), ' ');
    return text;
}

void printOverview(std::ostream& out) {
    out << "Rubble " << versionText() << ": where the deactivated elements of a collapse go.\n\n";
    for (const Command& command : commandTable()) {
        out << "  " << padded(usageOf(command), 30) << command.summary << '\n';
    }
    out << "  " << padded("rubble-cli --version", 30) << "print the version and the build\n"
        << "  " << padded("rubble-cli --man-page", 30) << "print the page for man\n"
        << "  " << padded("rubble-cli --completion", 30) << "print the completion for bash: eval \"$(rubble-cli --completion)\"\n"
        << "\nrubble-cli COMMAND --help lists the options of a command.\n"
        << exitCodesText;
}

void printHelp(std::ostream& out, const Command& command) {
    out << "Usage: " << usageOf(command) << " [options]\n\n" << command.summary << ".\n" << command.details << "\n\nOptions:\n";
    for (const Option& option : command.options) {
        std::string name(option.name);
        if (!option.value.empty()) {
            name += ' ' + std::string(option.value);
        }
        out << "  " << padded(name, 20) << option.help << (option.repeated ? " (may be repeated)" : "") << '\n';
    }
    out << '\n' << exitCodesText;
}

const Command& findCommand(const std::string& name) {
    for (const Command& command : commandTable()) {
        if (command.name == name) {
            return command;
        }
    }
    std::string names;
    for (const Command& command : commandTable()) {
        names += (names.empty() ? "" : ", ") + std::string(command.name);
    }
    throw UsageError({"cli.unknown_command", "There is no command \"{0}\".", {name}},
                     {"cli.unknown_command.remedy", "Commands: {0}.", {names}});
}

/// One command line on its way through: keeps what error messages need.
class Performance {
public:
    Performance(std::span<const std::string> words, std::ostream& out, std::ostream& err, bool progress)
        : m_words(words), m_out(out), m_err(err), m_line(err, progress) {}

    ExitCode perform() {
        if (m_words.empty()) {
            printOverview(m_err);
            return ExitCode::Usage;
        }
        const std::string& first = m_words.front();
        if (first == "--help" || first == "-h" || first == "help") {
            printOverview(m_out);
            return ExitCode::Ok;
        }
        if (first == "--version") {
            m_out << "rubble-cli " << versionText() << " (" << buildText() << ")\n";
            return ExitCode::Ok;
        }
        if (first == "--man-page" || first == "--completion") {
            m_out << (first == "--man-page" ? manPageText() : completionText());
            return ExitCode::Ok;
        }
        const Command& command = findCommand(first);
        const Arguments arguments(command, m_words.subspan(1));
        if (arguments.has("--help")) {
            printHelp(m_out, command);
            return ExitCode::Ok;
        }
        Session session(m_out, m_err, Execution([this](const Progress& progress) { m_line.show(progress); }), m_line);
        const Interruption interruption(session.execution());
        return command.perform(arguments, session);
    }

    void reportCancelled() {
        m_line.clear();
        m_err << "rubble-cli: cancelled\n";
        if (json()) {
            m_out << Json{{"cancelled", true}}.text() << '\n';
        }
    }

    void reportError(const Error& error) { report(error.message().id, englishText(error.message()), englishText(error.remedy())); }

    void report(const std::string& id, const std::string& what, const std::string& remedy) {
        m_line.clear();
        m_err << "rubble-cli: " << what << '\n';
        if (!remedy.empty()) {
            m_err << "  " << remedy << '\n';
        }
        if (json()) {
            Json object;
            object["error"] = {{"id", id}, {"what", what}, {"remedy", remedy}};
            m_out << object.text() << '\n';
        }
    }

private:
    /// Asked of the words themselves, because an error may have kept them from being parsed.
    bool json() const { return std::find(m_words.begin(), m_words.end(), "--json") != m_words.end(); }

    std::span<const std::string> m_words;
    std::ostream& m_out;
    std::ostream& m_err;
    ProgressLine m_line;
};

}  // namespace

ExitCode performCommandLine(std::span<const std::string> words, std::ostream& out, std::ostream& err, bool progress) {
    Performance performance(words, out, err, progress);
    ExitCode code = ExitCode::Failed;
    try {
        code = performance.perform();
    } catch (const Cancelled&) {
        performance.reportCancelled();
        code = ExitCode::Cancelled;
    } catch (const UsageError& error) {
        performance.reportError(error);
        code = ExitCode::Usage;
    } catch (const Error& error) {
        performance.reportError(error);
    } catch (const std::bad_alloc&) {
        performance.report("cli.out_of_memory", "There is not enough memory for this.",
                           "Close other programs, or work on a smaller FE result.");
    } catch (const std::exception& error) {
        performance.report("cli.unexpected", std::string("Something failed that should not: ") + error.what(),
                           "Please report it with the command line.");
    }
    out.flush();
    if (!out && code == ExitCode::Ok) {
        performance.report("cli.output_lost", "The output could not be written: the disk may be full.",
                           "Send it somewhere with more room.");
        code = ExitCode::Failed;
    }
    return code;
}

}  // namespace rubble::cli
