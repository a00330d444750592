#include "app/cli/frame/output_file.h"

#include <filesystem>

#include "core/base/error.h"
#include "io/base/files.h"

namespace rubble::cli {

namespace fs = std::filesystem;

void checkOutputPath(const std::string& path, std::span<const std::string> inputs) {
    std::error_code ignored;
    for (const std::string& input : inputs) {
        if (fs::equivalent(path, input, ignored)) {
            throw UsageError({"cli.output_is_input", "{0} is read by this command, so it cannot be written by it.", {path}},
                             {"cli.output_is_input.remedy", "Give the output another name.", {}});
        }
    }
    if (path.empty() || fs::is_directory(path, ignored)) {
        throw UsageError({"cli.output_is_folder", "\"{0}\" is not the name of a file to write.", {path}},
                         {"cli.output_is_folder.remedy", "Give the name of a file.", {}});
    }
    io::makeFolderOf(path);
}

void checkCsvPath(const Arguments& arguments, std::span<const std::string> inputs) {
    if (const auto path = arguments.value("--csv")) {
        checkOutputPath(*path, inputs);
    }
}

void writeCsv(const Arguments& arguments, const TextTable& table) {
    if (const auto path = arguments.value("--csv")) {
        io::writeAtomically(*path, [&](std::ostream& out) { table.writeCsv(out); });
    }
}

}  // namespace rubble::cli
