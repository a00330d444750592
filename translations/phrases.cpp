#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>

#include "core/fe/mesh.h"
#include "core/scenario/parameters.h"
#include "core/selftest/suite.h"
#include "translations/literals.h"

namespace {

namespace fs = std::filesystem;
using rubble::translations::isPhrase;
using rubble::translations::Literal;
using rubble::translations::literalsOf;

/// Texts by context, each once, in the order of the alphabet so that the catalogue keeps still.
struct Phrases {
    std::set<std::string> messages;
    std::set<std::string> parameters;
    std::set<std::string> choices;
    std::set<std::string> selfTest;
};

/// Files without text for the window: of self tests reports say the criteria alone, parameters are read from their table.
bool passedOver(const std::string& path) {
    static const char* const silent[] = {"core/selftest/", "core/scenario/parameter_table.cpp",
                                         "core/scenario/effect_parameters.cpp", "widgets/figures/palette", "io/base/machine.cpp"};
    return std::any_of(std::begin(silent), std::end(silent),
                       [&](const char* folder) { return path.find(folder) != std::string::npos; });
}

void collectMessages(const fs::path& root, Phrases& phrases) {
    for (const char* folder : {"core", "io", "widgets/render", "widgets/figures", "app/gui"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string path = entry.path().lexically_relative(root).generic_string();
            if ((entry.path().extension() != ".cpp" && entry.path().extension() != ".h") || passedOver(path)) {
                continue;
            }
            std::ifstream file(entry.path());
            std::stringstream source;
            source << file.rdbuf();
            const bool marked = path.starts_with("app/") || path.starts_with("widgets/");
            for (const Literal& literal : literalsOf(source.str())) {
                // Where Qt's own marks are at hand, only messages come without one.
                if (isPhrase(literal) && (!marked || literal.before.find('.') != std::string::npos)) {
                    phrases.messages.insert(literal.text);
                }
            }
        }
    }
}

void collectParameters(Phrases& phrases) {
    for (const rubble::Parameter& row : rubble::parameterTable()) {
        phrases.parameters.emplace(row.label);
        phrases.parameters.emplace(row.help);
        if (row.unit.find(" or ") != std::string_view::npos) {
            phrases.parameters.emplace(row.unit);
        }
        for (const std::string_view choice : row.choices) {
            std::string shown(choice);
            std::replace(shown.begin(), shown.end(), '_', ' ');
            phrases.choices.insert(shown);
        }
    }
    for (int shape = 0; shape <= static_cast<int>(rubble::ElementShape::Beam); ++shape) {
        phrases.choices.emplace(rubble::shapeName(static_cast<rubble::ElementShape>(shape)));
    }
}

void collectSelfTest(Phrases& phrases) {
    for (const rubble::selftest::HardCase& hardCase : rubble::selftest::hardCases()) {
        phrases.selfTest.emplace(hardCase.criterion);
    }
}

void write(std::ostream& out, const char* context, const std::set<std::string>& texts) {
    for (const std::string& text : texts) {
        out << "    QT_TRANSLATE_NOOP(\"" << context << "\", \"";
        for (const char c : text) {
            out << (c == '"' || c == '\\' ? "\\" : "") << (c == '\n' ? "\\n" : std::string(1, c));
        }
        out << "\"),\n";
    }
}

}  // namespace

// rubble-phrases SOURCE_ROOT OUT: the messages of core and io and the words of the parameter table as a source for lupdate.
int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: rubble-phrases SOURCE_ROOT OUT\n");
        return 2;
    }
    Phrases phrases;
    collectMessages(argv[1], phrases);
    collectParameters(phrases);
    collectSelfTest(phrases);
    std::ofstream out(argv[2]);
    out << "const char* const phrases[] = {\n";
    write(out, "messages", phrases.messages);
    write(out, "parameters", phrases.parameters);
    write(out, "choices", phrases.choices);
    write(out, "selftest", phrases.selfTest);
    out << "};\n";
    out.flush();
    if (!out) {
        std::fprintf(stderr, "rubble-phrases: %s cannot be written\n", argv[2]);
        return 1;
    }
    std::printf("%zu messages, %zu texts of parameters, %zu choices\n", phrases.messages.size(), phrases.parameters.size(),
                phrases.choices.size());
    return 0;
}
