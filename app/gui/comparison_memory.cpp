#include "app/gui/comparison_memory.h"

#include <QSettings>
#include <QStringList>
#include <cmath>

namespace rubble {

namespace {

const QString memory = QStringLiteral("comparison");

QStringList listOf(const std::vector<std::string>& values) {
    QStringList list;
    for (const std::string& value : values) {
        list << QString::fromStdString(value);
    }
    return list;
}

std::vector<std::string> valuesOf(const QStringList& list) {
    std::vector<std::string> values;
    for (const QString& each : list) {
        values.push_back(each.toStdString());
    }
    return values;
}

}  // namespace

void rememberComparison(const widgets::AccuracyPanel::Request& request) {
    QSettings settings;
    settings.remove(memory);
    settings.beginGroup(memory);
    settings.setValue(QStringLiteral("multiples"), listOf(request.multiples));
    settings.setValue(QStringLiteral("repeats"), request.repeats);
    settings.setValue(QStringLiteral("live_fps"), request.liveFps);
    QStringList tolerances;
    for (const double tolerance : request.tolerances) {
        tolerances << QString::number(tolerance, 'g', 17);
    }
    settings.setValue(QStringLiteral("tolerances_m"), tolerances);
    settings.beginWriteArray(QStringLiteral("varied"), static_cast<int>(request.varied.size()));
    for (std::size_t i = 0; i < request.varied.size(); ++i) {
        settings.setArrayIndex(static_cast<int>(i));
        settings.setValue(QStringLiteral("key"), QString::fromStdString(request.varied[i].key));
        settings.setValue(QStringLiteral("values"), listOf(request.varied[i].values));
    }
    settings.endArray();
    settings.endGroup();
}

widgets::AccuracyPanel::Request rememberedComparison(const widgets::AccuracyPanel::Request& standard) {
    widgets::AccuracyPanel::Request request = standard;
    QSettings settings;
    settings.beginGroup(memory);
    if (!settings.contains(QStringLiteral("multiples"))) {
        return request;
    }
    request.multiples = valuesOf(settings.value(QStringLiteral("multiples")).toStringList());
    request.liveFps = settings.value(QStringLiteral("live_fps"), standard.liveFps).toBool();
    bool number = false;
    const int repeats = settings.value(QStringLiteral("repeats")).toInt(&number);
    request.repeats = number && repeats >= 1 ? repeats : standard.repeats;
    std::vector<double> tolerances;
    for (const QString& each : settings.value(QStringLiteral("tolerances_m")).toStringList()) {
        const double tolerance = each.toDouble(&number);
        if (number && std::isfinite(tolerance)) {
            tolerances.push_back(tolerance);
        }
    }
    request.tolerances = tolerances.empty() ? standard.tolerances : tolerances;
    request.varied.clear();
    const int varied = settings.beginReadArray(QStringLiteral("varied"));
    for (int i = 0; i < varied; ++i) {
        settings.setArrayIndex(i);
        request.varied.push_back({settings.value(QStringLiteral("key")).toString().toStdString(),
                                  valuesOf(settings.value(QStringLiteral("values")).toStringList())});
    }
    settings.endArray();
    return request;
}

}  // namespace rubble
