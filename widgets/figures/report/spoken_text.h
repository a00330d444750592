#pragma once

#include <QString>
#include <functional>
#include <string>

#include "core/base/message.h"

namespace rubble::figures {

/// A text that core made in English (a place, a reason, a word), in the language that is spoken; what is not known stays as it is.
QString spokenText(const std::string& english);
/// Says an English text of a context in another language; as it is where it is not known.
using SaidIn = std::function<QString(const char* context, const QByteArray& english, const char* comment)>;
/// The same in the language that a catalogue has.
QString spokenTextIn(const std::string& english, const SaidIn& say);
/// Whether an argument of a message is a name or a key: it stands in quotation marks or brackets in the English pattern, and is
/// said as it is in every language. A component may be called "beam", which is a word of the catalogue as well.
bool isVerbatim(const std::string& pattern, std::size_t argument);
/// The name of a setting as it stands beside its field, "Density, pier"; its key where there is no such setting.
QString spokenSetting(const std::string& key);
/// A value of a setting as its field has it: switches and choices are words of the language, numbers and texts stay as they are.
QString spokenValue(const std::string& key, const std::string& value);
/// The arguments of a message that are words of core, each by how it is said in another language.
void sayArguments(Message& message, const std::function<std::string(const std::string&)>& say);

}  // namespace rubble::figures
