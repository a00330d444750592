#include "io/exports/report_notes.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/base/files.h"
#include "io/json/json_cursor.h"
#include "io/json/json_document.h"
#include "io/json/json_text.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

constexpr JsonKind notesKind{"rubble-report-notes", 1, std::uintmax_t{16} << 20};

}  // namespace

bool ReportNotes::empty() const {
    return question.empty() && author.empty() && causes.empty() && words.custody.empty() && words.alternatives.empty() &&
           words.change.empty() && words.summary.empty() && words.qualification.empty();
}

std::string reportNotesPath(const std::string& casePath) {
    return casePath + ".report.json";
}

namespace {

ReportNotes notesOf(const nlohmann::json& document, const std::string& file) {
    const JsonCursor top(document, file);
    ReportNotes notes;
    notes.question = top["question"].text();
    notes.author = top["author"].text();
    notes.causes = top["causes"].text();
    notes.words = {top["custody"].text(), top["alternatives"].text(), top["change"].text(), top["summary"].text()};
    // Notes of earlier versions have none.
    if (top.has("qualification")) {
        notes.words.qualification = top["qualification"].text();
    }
    return notes;
}

}  // namespace

ReportNotes readReportNotes(const std::string& file) {
    std::error_code failed;
    if (!fs::exists(fs::symlink_status(file, failed))) {
        return {};
    }
    return notesOf(readJsonDocument(file, notesKind), file);
}

ReportNotes reportNotesFrom(const std::string& text, const std::string& name) {
    return notesOf(jsonDocumentFrom(text, name, notesKind), name);
}

void writeReportNotes(const std::string& file, const ReportNotes& notes) {
    std::error_code failed;
    if (notes.empty()) {
        fs::remove(file, failed);
        return;
    }
    const nlohmann::json document = {{"format", notesKind.format},
                                     {"version", notesKind.version},
                                     {"question", notes.question},
                                     {"author", notes.author},
                                     {"causes", notes.causes},
                                     {"custody", notes.words.custody},
                                     {"alternatives", notes.words.alternatives},
                                     {"change", notes.words.change},
                                     {"summary", notes.words.summary},
                                     {"qualification", notes.words.qualification}};
    fs::create_directories(fs::path(file).parent_path(), failed);
    // Whatever is wrong with the folder is told by the writing.
    writeAtomically(file, [&](std::ostream& out) { out << jsonText(document) << '\n'; });
}

}  // namespace rubble::io
