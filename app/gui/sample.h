#pragma once

#include <QString>

namespace rubble {

/// Path of the embedded sample: the sample case if there is one, else its FE result; empty if neither is installed.
QString samplePath();

}  // namespace rubble
