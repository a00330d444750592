#pragma once

#include <QList>
#include <QString>
#include <QStringList>
#include <QTranslator>
#include <string_view>

namespace rubble::widgets {

/// A text of the program as it stands in the sources, with the context that it is translated in.
struct SourceText {
    QByteArray context;
    QByteArray text;
    QByteArray comment;

    friend bool operator==(const SourceText&, const SourceText&) = default;
};

/// The words of one language. It remembers what has been asked for: the manual looks for a figure by the words of the sources.
class Catalogue : public QTranslator {
public:
    /// @param language  a code of languageCodes(); English is the language of the sources and has no file
    explicit Catalogue(const QString& language, QObject* parent = nullptr);

    const QString& language() const { return m_language; }
    /// English stands in front of other languages as well: it has words, those of the sources.
    bool isEmpty() const override { return false; }
    QString translate(const char* context, const char* source, const char* comment = nullptr, int n = -1) const override;

    /// Everything that has been asked for since the start, in any language.
    static QList<SourceText> spoken();

private:
    QString m_language;
};

/// "en", "zh_CN": what there is a catalogue for.
QStringList languageCodes();
/// The name of a language in itself: "English", "简体中文".
QString languageName(const QString& code);
/// The language of the system where there is a catalogue for it; English otherwise.
QString systemLanguage();
/// The language that is spoken now.
QString currentLanguage();

/// Speaks a language from now on: words, Qt's own dialogs, numbers and dates. Windows that are open keep the words they have.
/// "system" is systemLanguage(). An unknown code is English.
void speak(const QString& language);

/// A text of core in the language of the window. Its context is one of those that the catalogue collects: "messages", "parameters",
/// "choices"; or that of the widget that says it too.
QString said(const char* context, std::string_view english);

}  // namespace rubble::widgets
