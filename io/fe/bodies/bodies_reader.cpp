#include "io/fe/bodies/bodies_reader.h"

#include <algorithm>
#include <sstream>

#include "core/base/small_letters.h"
#include "core/fe/loose_bodies.h"
#include "io/base/trimmed.h"
#include "io/fe/bodies/body_table.h"

namespace rubble::io {

bool recognisesBodies(const FileHead& head) {
    std::istringstream lines(head.bytes);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("\xef\xbb\xbf")) {
            line.erase(0, 3);
        }
        const std::string own = inSmallLetters(trimmed(line));
        if (!own.empty() && !own.starts_with('#') && !own.starts_with("sep=")) {
            return isBodyHeading(own);
        }
    }
    return false;
}

FeResult::Contents readBodies(const std::string& path, const ImportSettings&, const Execution&) {
    BodyTable table = readBodyTable(path);
    FeResult::Contents contents = contentsOf(table.bodies);
    contents.findings = std::move(table.findings);
    return contents;
}

}  // namespace rubble::io
