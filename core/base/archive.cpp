#include "core/base/archive.h"

namespace rubble {

void Archive::fail() {
    throw ParseError({"base.archive.damaged", "What was kept is not whole.", {}},
                     {"base.archive.damaged.remedy", "It is made again; delete the file if this is said each time.", {}});
}

}  // namespace rubble
