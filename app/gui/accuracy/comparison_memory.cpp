#include "app/gui/accuracy/comparison_memory.h"

#include <QSettings>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "core/analysis/accuracy/accuracy_study.h"

namespace rubble {

namespace {

const QString memory = QStringLiteral("comparison");

std::string joined(const std::vector<std::string>& values) {
    std::string text;
    for (const std::string& value : values) {
        text += (text.empty() ? "" : ",") + value;
    }
    return text;
}

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> values;
    for (const QString& value : QString::fromStdString(text).split(u',', Qt::SkipEmptyParts)) {
        values.push_back(value.toStdString());
    }
    return values;
}

/// A number of repeats.
int countIn(const std::string& text, int least, int otherwise) {
    bool number = false;
    const int count = QString::fromStdString(text).toInt(&number);
    return number ? std::clamp(count, least, 100) : otherwise;
}

}  // namespace

std::vector<std::string> wordsOf(const widgets::AccuracyPanel::Request& request) {
    std::vector<std::string> words{"--multiples",       joined(request.multiples),
                                   "--repeats",         std::to_string(request.repeats),
                                   "--setting-repeats", std::to_string(request.settingRepeats)};
    for (const VariedParameter& varied : request.varied) {
        words.insert(words.end(), {"--vary", varied.key + "=" + joined(varied.values)});
    }
    return words;
}

widgets::AccuracyPanel::Request requestFrom(const std::vector<std::string>& words, widgets::AccuracyPanel::Request request) {
    request.multiples.clear();
    request.varied.clear();
    request.repeats = StudySettings().repeats;
    request.settingRepeats = AccuracyOptions().settingRepeats;
    bool multiples = false;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        const std::string& value = words[i + 1];
        const std::size_t sign = value.find('=');
        if (words[i] == "--multiples") {
            request.multiples = split(value);
            multiples = true;
        } else if (words[i] == "--vary" && sign != std::string::npos) {
            request.varied.push_back({value.substr(0, sign), split(value.substr(sign + 1))});
        } else if (words[i] == "--repeats") {
            request.repeats = countIn(value, 1, request.repeats);
        } else if (words[i] == "--setting-repeats") {
            request.settingRepeats = countIn(value, 0, request.settingRepeats);
        }
    }
    if (!multiples && request.varied.empty()) {
        request.multiples = usualMultiples();
    }
    return request;
}

void rememberComparison(const widgets::AccuracyPanel::Request& request) {
    QSettings settings;
    settings.beginGroup(memory);
    QStringList words;
    for (const std::string& word : wordsOf(request)) {
        words << QString::fromStdString(word);
    }
    QStringList tolerances;
    for (const double tolerance : request.tolerances) {
        tolerances << QString::number(tolerance, 'g', 17);
    }
    settings.setValue(QStringLiteral("words"), words);
    settings.setValue(QStringLiteral("tolerances_m"), tolerances);
    settings.setValue(QStringLiteral("live_fps"), request.liveFps);
}

widgets::AccuracyPanel::Request rememberedComparison(const widgets::AccuracyPanel::Request& standard) {
    QSettings settings;
    settings.beginGroup(memory);
    if (!settings.contains(QStringLiteral("words"))) {
        return standard;
    }
    std::vector<std::string> words;
    for (const QString& word : settings.value(QStringLiteral("words")).toStringList()) {
        words.push_back(word.toStdString());
    }
    widgets::AccuracyPanel::Request request = requestFrom(words, standard);
    std::vector<double> tolerances;
    for (const QString& each : settings.value(QStringLiteral("tolerances_m")).toStringList()) {
        bool number = false;
        const double tolerance = each.toDouble(&number);
        if (number && std::isfinite(tolerance)) {
            tolerances.push_back(tolerance);
        }
    }
    request.tolerances = tolerances.empty() ? standard.tolerances : tolerances;
    request.liveFps = settings.value(QStringLiteral("live_fps"), standard.liveFps).toBool();
    return request;
}

}  // namespace rubble
