#pragma once

#include <QString>
#include <string>

namespace rubble::figures {

/// A text that core made in English (a place, a reason, a word), in the language that is spoken; what is not known stays as it is.
QString spokenText(const std::string& english);

}  // namespace rubble::figures
