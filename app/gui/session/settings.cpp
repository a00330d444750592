#include "app/gui/session/settings.h"

#include <QFileInfo>

#include "widgets/basics/language.h"

namespace rubble {

namespace {

/// Keys in the settings file; others read some of them by these names.
constexpr const char* languageKey = "language";
constexpr const char* themeKey = "theme";
constexpr const char* coloursKey = "colours";
constexpr const char* materialsKey = "presentation_style";
constexpr const char* unitsKey = "units";
constexpr const char* threadsKey = "threads";
constexpr const char* memoryKey = "memory_mib";
constexpr const char* autosaveKey = "autosave_seconds";
constexpr const char* keepRunsKey = "keep_runs_gib";
constexpr const char* runsFolderKey = "runs_folder";
constexpr const char* copiesKey = "keep_copies";
constexpr const char* simplifyKey = "simplify_moving";

const QStringList& colourNames() {
    static const QStringList names{QStringLiteral("vermilion"), QStringLiteral("yellow")};
    return names;
}

const QStringList& unitNames() {
    static const QStringList names{QStringLiteral("SI"), QStringLiteral("mm-t-s"), QStringLiteral("US")};
    return names;
}

/// Reads single values and notes which of them make no sense.
class Reader {
public:
    Reader(QSettings& settings, QStringList* complaints) : m_settings(settings), m_complaints(complaints) {}

    QString oneOf(const char* key, const QStringList& choices, const QString& otherwise) {
        const QVariant value = m_settings.value(QLatin1String(key), otherwise);
        return choices.contains(value.toString()) ? value.toString() : (refuse(key), otherwise);
    }
    int number(const char* key, int low, int high, int otherwise) {
        bool ok = false;
        const int value = m_settings.value(QLatin1String(key), otherwise).toInt(&ok);
        return ok && value >= low && value <= high ? value : (refuse(key), otherwise);
    }
    bool flag(const char* key, bool otherwise) {
        const QVariant value = m_settings.value(QLatin1String(key), otherwise);
        const QString text = value.toString();
        return text == QLatin1String("true") || text == QLatin1String("false") ? value.toBool() : (refuse(key), otherwise);
    }

private:
    void refuse(const char* key) {
        if (m_complaints != nullptr) {
            *m_complaints << QLatin1String(key);
        }
    }

    QSettings& m_settings;
    QStringList* m_complaints;
};

}  // namespace

widgets::Preferences readPreferences(QSettings& settings, QStringList* complaints) {
    const widgets::Preferences delivered;
    settings.sync();
    // A file that holds something but no key is no settings file.
    const bool senseless = settings.allKeys().isEmpty() && QFileInfo(settings.fileName()).size() > 0;
    if (settings.status() != QSettings::NoError || senseless) {
        if (complaints != nullptr) {
            *complaints << settings.fileName();
        }
        return delivered;
    }
    Reader reader(settings, complaints);
    widgets::Preferences found;
    const QString system = QStringLiteral("system");
    found.language = reader.oneOf(languageKey, widgets::languageCodes() + QStringList(system), delivered.language);
    found.theme = reader.oneOf(themeKey, {system, QStringLiteral("light"), QStringLiteral("dark")}, delivered.theme);
    found.colours = static_cast<figures::ColourSet>(
        colourNames().indexOf(reader.oneOf(coloursKey, colourNames(), colourNames()[static_cast<int>(delivered.colours)])));
    found.units = static_cast<figures::UnitSet>(
        unitNames().indexOf(reader.oneOf(unitsKey, unitNames(), unitNames()[static_cast<int>(delivered.units)])));
    found.threads = reader.number(threadsKey, 0, widgets::mostThreads, delivered.threads);
    found.memoryMib = reader.number(memoryKey, widgets::leastMemoryMib, widgets::mostMemoryMib, delivered.memoryMib);
    found.autosaveSeconds = reader.number(autosaveKey, 0, widgets::mostAutosaveSeconds, delivered.autosaveSeconds);
    found.keepRunsGib = reader.number(keepRunsKey, 0, widgets::mostKeptGib, delivered.keepRunsGib);
    found.runsFolder = settings.value(QLatin1String(runsFolderKey)).toString();
    found.keepCopies = reader.flag(copiesKey, delivered.keepCopies);
    found.materials = reader.flag(materialsKey, delivered.materials);
    found.simplify = reader.flag(simplifyKey, delivered.simplify);
    return found;
}

void writePreferences(QSettings& settings, const widgets::Preferences& preferences) {
    settings.setValue(QLatin1String(languageKey), preferences.language);
    settings.setValue(QLatin1String(themeKey), preferences.theme);
    settings.setValue(QLatin1String(coloursKey), colourNames()[static_cast<int>(preferences.colours)]);
    settings.setValue(QLatin1String(unitsKey), unitNames()[static_cast<int>(preferences.units)]);
    settings.setValue(QLatin1String(threadsKey), preferences.threads);
    settings.setValue(QLatin1String(memoryKey), preferences.memoryMib);
    settings.setValue(QLatin1String(autosaveKey), preferences.autosaveSeconds);
    settings.setValue(QLatin1String(keepRunsKey), preferences.keepRunsGib);
    settings.setValue(QLatin1String(runsFolderKey), preferences.runsFolder);
    settings.setValue(QLatin1String(copiesKey), preferences.keepCopies);
    settings.setValue(QLatin1String(materialsKey), preferences.materials);
    settings.setValue(QLatin1String(simplifyKey), preferences.simplify);
}

}  // namespace rubble
