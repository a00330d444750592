#include "io/run/shown_span.h"

#include <algorithm>

namespace rubble::io {

ShownSpan shownSpan(const Carrier& carrier, const Fragment& fragment, const BodyRecord& body, bool leftIsland) {
    return {leftIsland ? carrier.from : std::max(carrier.from, fragment.birthTime),
            std::min({carrier.to, fragment.endTime, body.to})};
}

}  // namespace rubble::io
