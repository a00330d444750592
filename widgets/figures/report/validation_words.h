#pragma once

#include <QString>
#include <string>

namespace rubble::figures {

/// Titles, names and reasons of the sets that come with the program, in the language that is spoken. What a set of the user says,
/// and citations, stay as they are.
QString validationWords(const std::string& english);

}  // namespace rubble::figures
