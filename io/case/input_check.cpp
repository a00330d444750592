#include "io/case/input_check.h"

#include <filesystem>

#include "core/base/error.h"
#include "io/case/case_file.h"

namespace rubble::io {

FoundInput findInput(const std::string& casePath, const CaseInput& input, const InputDigest& known, const Execution& execution) {
    std::error_code ignored;
    FoundInput found{input.id, inputPath(casePath, input), false, known.against(input.sha256)};
    found.exists = !known.sha256.empty() || std::filesystem::exists(found.path, ignored);
    if (found.exists && known.sha256.empty() && !input.sha256.empty()) {
        try {
            found.sha256 = digestOfInput(found.path, input.role, execution).against(input.sha256);
        } catch (const Error&) {
            // Nothing that can be read: the reader of the input says why.
        }
    }
    return found;
}

}  // namespace rubble::io
