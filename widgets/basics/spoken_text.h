#pragma once

#include <QString>
#include <string>

namespace rubble::widgets {

/// A text that core made in English (a place, a reason, a word), in the language of the window; what is not known stays as it is.
QString spokenText(const std::string& english);

}  // namespace rubble::widgets
