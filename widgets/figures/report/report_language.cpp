#include "widgets/figures/report/report_language.h"

#include <QCoreApplication>
#include <QTranslator>

#include <array>
#include <cassert>

#include "core/scenario/setting_names.h"
#include "widgets/figures/report/spoken_text.h"

namespace rubble::figures {

namespace {

const char* const catalogueFile = ":/translations/rubble_zh_CN.qm";

/// Where words of tables have their translations, beside messages. Values of messages are not looked up here: a component may be
/// called as a material is.
constexpr std::array tables{"parameters", "choices", "validation", "rubble::figures::ValidationRows", "rubble", "HealthGrade"};

/// Names of components and files have no translation and stay as they are.
QString inChinese(const QTranslator& catalogue, const char* context, const QByteArray& english, const char* comment) {
    const QString said = catalogue.translate(context, english.constData(), comment);
    return said.isEmpty() ? QString::fromUtf8(english) : said;
}

std::string patternInChinese(const QTranslator& catalogue, const std::string& english) {
    QString said = catalogue.translate("messages", english.c_str());
    for (const char* const* table = tables.begin(); said.isEmpty() && table != tables.end(); ++table) {
        said = catalogue.translate(*table, english.c_str());
    }
    return said.isEmpty() ? english : said.toStdString();
}

}  // namespace

std::function<std::string(const Message&)> chineseWords(bool settingsNamed) {
    const auto catalogue = std::make_shared<QTranslator>();
    [[maybe_unused]] const bool there = catalogue->load(QLatin1String(catalogueFile));
    assert(there && "the catalogue is a resource of the program");
    const CatalogueWords words = [catalogue](std::string_view context, std::string_view english, std::string_view comment) {
        const std::string in(context);
        const std::string text(english);
        const std::string told(comment);
        const QString said = catalogue->translate(in.c_str(), text.c_str(), told.empty() ? nullptr : told.c_str());
        return said.isEmpty() ? text : said.toStdString();
    };
    return [catalogue, words, settingsNamed](const Message& message) {
        Message said = message;
        const SaidIn say = [&](const char* context, const QByteArray& english, const char* comment) {
            return inChinese(*catalogue, context, english, comment);
        };
        sayArguments(said, [&](const std::string& text) { return spokenTextIn(text, say).toStdString(); });
        said.pattern = patternInChinese(*catalogue, message.pattern);
        if (settingsNamed) {
            said.pattern = withSettingNames(said.pattern, words);
        }
        return englishText(said);
    };
}

WrittenLanguage::WrittenLanguage(const std::string& code) {
    if (code == "zh_CN") {
        m_words = std::make_unique<QTranslator>();
        [[maybe_unused]] const bool there = m_words->load(QLatin1String(catalogueFile));
        assert(there && "the catalogue is a resource of the program");
        QCoreApplication::installTranslator(m_words.get());
        QLocale::setDefault(QLocale(QString::fromStdString(code)));
    }
}

WrittenLanguage::~WrittenLanguage() {
    if (m_words != nullptr) {
        QCoreApplication::removeTranslator(m_words.get());
        QLocale::setDefault(m_before);
    }
}

std::function<QString(const Message&)> WrittenLanguage::say() const {
    if (m_words == nullptr) {
        return {};
    }
    return [](const Message& message) {
        Message said = message;
        sayArguments(said, [](const std::string& words) { return spokenText(words).toStdString(); });
        said.pattern = spokenText(message.pattern).toStdString();
        return QString::fromStdString(englishText(said));
    };
}

}  // namespace rubble::figures
