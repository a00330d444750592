#pragma once

#include <QLocale>
#include <QString>
#include <functional>
#include <memory>
#include <string>

#include "core/base/message.h"

class QTranslator;

namespace rubble::figures {

/// Messages in Chinese, also what stands in them as words; numbers as englishText() has them. English where a text lacks. A message
/// without values may also be a word of a table: name, choice or unit of a setting, a figure of a validation.
/// @param settingsNamed  settings by their names instead of their keys, for who has no command line before him
std::function<std::string(const Message&)> chineseWords(bool settingsNamed = false);

/// While one lives, what this program draws and writes speaks a language: words, numbers and dates. For programs without a window,
/// which speaks by itself.
class WrittenLanguage {
public:
    /// @param code  "en" or "zh_CN"; the application must be there
    explicit WrittenLanguage(const std::string& code);
    ~WrittenLanguage();
    WrittenLanguage(const WrittenLanguage&) = delete;
    WrittenLanguage& operator=(const WrittenLanguage&) = delete;

    /// How messages are said in it; empty for English.
    std::function<QString(const Message&)> say() const;

private:
    std::unique_ptr<QTranslator> m_words;
    QLocale m_before;
};

}  // namespace rubble::figures
