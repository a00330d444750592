#include "io/case/autosave_file.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/json/json_cursor.h"
#include "io/json/json_document.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

// As large as a case.
constexpr JsonKind autosaveKind{"rubble-autosave", 1, std::uintmax_t{64} << 20};

}  // namespace

void writeAutosave(const std::string& file, const AutosavedCase& autosaved) {
    std::error_code failed;
    fs::create_directories(fs::path(file).parent_path(), failed);
    // Whatever is wrong with the folder is told by the writing.
    const nlohmann::json document = {{"format", autosaveKind.format}, {"version", autosaveKind.version},
                                     {"path", autosaved.path},        {"base", autosaved.base},
                                     {"saved_at", autosaved.savedAt}, {"case", parseJson(caseText(autosaved.theCase), file)}};
    const std::string text = document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    writeAtomically(file, [&text](std::ostream& out) { out << text; });
}

AutosavedCase readAutosave(const std::string& file) {
    const nlohmann::json document = readJsonDocument(file, autosaveKind);
    const JsonCursor top(document, file);
    return {top["path"].text(), top["base"].text(), top["saved_at"].text(), caseFromText(top["case"].value().dump(), file)};
}

}  // namespace rubble::io
