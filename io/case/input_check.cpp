#include "io/case/input_check.h"

#include <filesystem>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/fe/fe_reader.h"

namespace rubble::io {

std::string sha256OfInput(const std::string& path, InputRole role, const Execution& execution) {
    execution.check();
    return role == InputRole::Fe ? sha256OfFe(path) : sha256OfFile(path, [&](std::size_t) { execution.check(); });
}

FoundInput findInput(const std::string& casePath, const CaseInput& input, const std::string& known, const Execution& execution) {
    std::error_code ignored;
    FoundInput found{input.id, inputPath(casePath, input), false, known};
    found.exists = !known.empty() || std::filesystem::exists(found.path, ignored);
    if (found.exists && known.empty() && !input.sha256.empty()) {
        try {
            found.sha256 = sha256OfInput(found.path, input.role, execution);
        } catch (const Error&) {
            // Nothing that can be read: the reader of the input says why.
        }
    }
    return found;
}

}  // namespace rubble::io
