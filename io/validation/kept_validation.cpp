#include "io/validation/kept_validation.h"

#include <algorithm>
#include <filesystem>

#include "core/base/build.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "io/base/files.h"
#include "io/base/machine.h"
#include "io/validation/validation_json.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

/// Raised where sets, scenes or measures change, which the text of the build does not know of.
constexpr int keptVersion = 3;

fs::path folderOf(const std::string& cache) {
    Hasher hasher;
    hasher.text("validation").value(keptVersion).text(buildText());
    return fs::path(cache) / "validation" / hasher.finish().hex();
}

}  // namespace

void keepValidation(const ValidationRecord& record, const std::string& cache) {
    Hasher hasher;
    hasher.text(record.id).text(record.folder);
    writeIn((folderOf(cache) / (hasher.finish().hex() + ".json")).string(), validationJson(record).text());
}

std::vector<ValidationRecord> keptValidations(const std::string& cache, Findings& findings) {
    std::vector<ValidationRecord> records;
    std::error_code ignored;
    for (fs::directory_iterator it(folderOf(cache), ignored), end; it != end; it.increment(ignored)) {
        const std::string path = it->path().string();
        const std::optional<std::string> text = hasEnding(path, ".json") ? contentOf(path) : std::nullopt;
        if (!text) {
            continue;
        }
        try {
            records.push_back(validationFromText(*text, path));
        } catch (const ParseError& error) {
            findings.add({"validation.damaged", "What was kept of a validation is damaged and left out.", {}},
                         {"validation.damaged.remedy", "Delete the file named and validate again.", {}}, error.what());
        }
    }
    std::sort(records.begin(), records.end(), [](const ValidationRecord& a, const ValidationRecord& b) {
        return std::tie(a.id, a.folder) < std::tie(b.id, b.folder);
    });
    return records;
}

std::vector<ValidationRecord> keptValidations() {
    try {
        Findings unread;
        return keptValidations(cacheFolder(), unread);
    } catch (const WorldError&) {
        return {};
    }
}

}  // namespace rubble::io
