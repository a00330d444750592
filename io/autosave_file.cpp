#include "io/autosave_file.h"

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "io/case_file.h"
#include "io/files.h"
#include "io/json_cursor.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

constexpr const char* formatName = "rubble-autosave";
constexpr std::int64_t formatVersion = 1;
// As for a case.
constexpr std::uintmax_t bytesMax = std::uintmax_t{64} << 20;

}  // namespace

void writeAutosave(const std::string& file, const AutosavedCase& autosaved) {
    std::error_code failed;
    fs::create_directories(fs::path(file).parent_path(), failed);
    // Whatever is wrong with the folder is told by the writing.
    const nlohmann::json document = {{"format", formatName},          {"version", formatVersion},
                                     {"path", autosaved.path},        {"base", autosaved.base},
                                     {"saved_at", autosaved.savedAt}, {"case", parseJson(caseText(autosaved.theCase), file)}};
    const std::string text = document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    writeAtomically(file, [&text](std::ostream& out) { out << text; });
}

AutosavedCase readAutosave(const std::string& file) {
    std::error_code failed;
    const std::uintmax_t size = fs::file_size(file, failed);
    std::ifstream in;
    if (!failed && size <= bytesMax) {
        in.open(file, std::ios::binary);
    }
    if (!in.is_open()) {
        throw WorldError({"io.autosave.unreadable", "Cannot read the unsaved work in {0}", {file}},
                         {"io.file.unreadable.remedy", "Check that the file exists and that you may read it.", {}});
    }
    const nlohmann::json document = parseJson(std::string(std::istreambuf_iterator<char>(in), {}), file);
    const JsonCursor top(document, file);
    if (top["format"].text() != formatName) {
        top["format"].fail(std::string("\"") + formatName + "\"");
    }
    if (top["version"].integer() != formatVersion) {
        top["version"].fail(std::to_string(formatVersion));
    }
    return {top["path"].text(), top["base"].text(), top["saved_at"].text(), caseFromText(top["case"].value().dump(), file)};
}

}  // namespace rubble::io
