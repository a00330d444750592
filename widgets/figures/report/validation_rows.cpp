#include "widgets/figures/report/validation_rows.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/figures/report/report_sections.h"
#include "widgets/figures/report/spoken_text.h"
#include "widgets/figures/report/validation_words.h"

namespace rubble::figures {

namespace {

struct ValidationWords {
    Q_DECLARE_TR_FUNCTIONS(rubble::figures::ValidationRows)
};

QString plain(const std::string& text) {
    return QString::fromStdString(text).toHtmlEscaped();
}

/// A set and its variant.
QString setName(const ValidationRecord& record, const VariantRecord& variant) {
    return ValidationWords::tr("%1, %2", "set, variant")
        .arg(QString::fromStdString(record.id), validationWords(variant.name))
        .toHtmlEscaped();
}

QString unitName(const std::string& unit) {
    return unit == "deg" ? ValidationWords::tr("deg") : plain(unit);
}

/// What of a figure is asked for.
QString partOf(const std::string& key) {
    const std::array names{
        std::pair{"error", ValidationWords::tr("error", "of a mean")},
        std::pair{"scatter_ratio", ValidationWords::tr("ratio of the scatters")},
        std::pair{"simulated", ValidationWords::tr("simulated")},
        std::pair{"median", ValidationWords::tr("median")},
    };
    const auto* known = std::ranges::find(names, key, [](const auto& each) { return std::string(each.first); });
    return known != names.end() ? known->second : plain(key);
}

/// Name of a figure in the language that is spoken; its key where it has none.
QString nameOf(const std::string& key) {
    const std::array names{
        std::pair{"run_out_m", ValidationWords::tr("run-out")},
        std::pair{"fall_m", ValidationWords::tr("fall")},
        std::pair{"rotation_deg", ValidationWords::tr("net rotation")},
        std::pair{"rotation_error_deg", ValidationWords::tr("error of rotation")},
        std::pair{"right_face_share", ValidationWords::tr("right face up")},
        std::pair{"position_error_m", ValidationWords::tr("error of place")},
        std::pair{"centroid_offset_m", ValidationWords::tr("centroid of the deposit is off by")},
        std::pair{"solid_fraction", ValidationWords::tr("solid fraction")},
        std::pair{"bulking", ValidationWords::tr("bulking")},
        std::pair{"angle_deg", ValidationWords::tr("angle at which it gives way")},
        std::pair{"limit_angle_deg", ValidationWords::tr("the same by limit analysis")},
        std::pair{"thickness_over_radius", ValidationWords::tr("least thickness over radius")},
        std::pair{"limit_thickness_over_radius", ValidationWords::tr("the same by limit analysis")},
        std::pair{"over_limit", ValidationWords::tr("over limit analysis")},
        std::pair{"run_out_exponent", ValidationWords::tr("exponent of the run-out")},
        std::pair{"run_out_factor", ValidationWords::tr("factor of the run-out")},
        std::pair{"run_out_over_law", ValidationWords::tr("run-out over the law")},
        std::pair{"height_over_law", ValidationWords::tr("height over the law")},
    };
    for (const auto& [known, name] : names) {
        if (key == known) {
            return name;
        }
    }
    const std::size_t dot = key.rfind('.');
    const std::string statistic = dot != std::string::npos ? key.substr(dot + 1) : "";
    if (statistic == "median") {
        return ValidationWords::tr("%1, median").arg(nameOf(key.substr(0, dot)));
    }
    return statistic == "ninetieth" ? ValidationWords::tr("%1, 90 %").arg(nameOf(key.substr(0, dot))) : plain(key);
}

/// "run_out_m[Plate]" is the run-out of a group.
QString figureName(const std::string& key, const std::string& unit) {
    const std::size_t open = key.find('['), close = key.find(']');
    QString name = nameOf(key);
    if (open != std::string::npos && close != std::string::npos && close > open) {
        name = nameOf(key.substr(0, open) + key.substr(close + 1)) + QStringLiteral(", ") +
               plain(key.substr(open + 1, close - open - 1));
    }
    return unit.empty() ? name : QStringLiteral("%1 [%2]").arg(name, unitName(unit));
}

QString interval(const ConfidenceInterval& value) {
    if (!std::isfinite(value.low) || !std::isfinite(value.high)) {
        return reportNumber(value.value);
    }
    return ValidationWords::tr("%1 (%2 to %3)").arg(reportNumber(value.value), reportNumber(value.low), reportNumber(value.high));
}

QString sample(const MeanAndScatter& of) {
    return std::isfinite(of.scatter) ? QStringLiteral("%1 ± %2").arg(reportNumber(of.mean), reportNumber(of.scatter, 2))
                                     : reportNumber(of.mean);
}

/// "at least 0.54", "below run_out_m[St. Leonard].simulated 84.2" as VerdictRecord::asked has them.
QString saidBound(const QString& english) {
    const QString number = english.section(u' ', -1);
    if (english.startsWith(QLatin1String("at least "))) {
        return ValidationWords::tr("at least %1").arg(number);
    }
    if (english.startsWith(QLatin1String("at most "))) {
        return ValidationWords::tr("at most %1").arg(number);
    }
    const QString other = english.section(u' ', 1, -2).section(u'.', 0, -2);
    return english.startsWith(QLatin1String("below "))
               ? ValidationWords::tr("below %1 (%2)").arg(number, figureName(other.toStdString(), ""))
               : english.toHtmlEscaped();
}

QString saidAsked(const std::string& english) {
    QString said;
    for (const QString& each : QString::fromStdString(english).split(QStringLiteral(", "))) {
        said = said.isNull() ? saidBound(each) : ValidationWords::tr("%1 and %2", "two bounds").arg(said, saidBound(each));
    }
    return said;
}

/// What is asked of figures whose keys begin so; each as far as it stands in the record.
QString askedOf(const VariantRecord& variant, const std::string& key) {
    QStringList parts;
    for (const VerdictRecord& verdict : variant.verdicts) {
        if (verdict.figure == key || verdict.figure.starts_with(key + ".")) {
            const QString asked = saidAsked(verdict.asked);
            const QString words =
                verdict.figure == key
                    ? asked
                    : ValidationWords::tr("%1 %2", "what, asked").arg(partOf(verdict.figure.substr(key.size() + 1)), asked);
            parts
                << (verdict.within ? ValidationWords::tr("%1: holds") : ValidationWords::tr("%1: <b>does not hold</b>")).arg(words);
        }
    }
    return parts.isEmpty() ? QStringLiteral("–") : parts.join(QStringLiteral("; "));
}

}  // namespace

std::vector<ValidationRow> validationRows(const ValidationRecord& record) {
    const QString none = QStringLiteral("–");
    std::vector<ValidationRow> rows;
    for (const VariantRecord& variant : record.variants) {
        const QString set = setName(record, variant);
        for (const QuantityRecord& quantity : variant.quantities) {
            const SampleComparison& c = quantity.comparison;
            rows.push_back({set, figureName(quantity.key, quantity.unit), sample(c.measured), sample(c.simulated),
                            interval(c.error),
                            ValidationWords::tr("%1 (%2)").arg(reportNumber(c.area, 2), reportNumber(c.areaByChance, 2)),
                            QString::number(c.lost), askedOf(variant, quantity.key)});
        }
        for (const SetFigure& figure : variant.otherFigures()) {
            rows.push_back({set, figureName(figure.key, figure.unit), none, interval(figure.value), none, none, none,
                            askedOf(variant, figure.key)});
        }
    }
    return rows;
}

std::vector<ValidationParameterRow> validationParameters(const ValidationRecord& record) {
    std::vector<ValidationParameterRow> rows;
    for (const VariantRecord& variant : record.variants) {
        for (const SetParameter& parameter : variant.parameters) {
            rows.push_back({setName(record, variant),
                            QStringLiteral("%1 = %2")
                                .arg(spokenSetting(parameter.key), spokenValue(parameter.key, parameter.value))
                                .toHtmlEscaped(),
                            validationWords(parameter.source).toHtmlEscaped()});
        }
    }
    return rows;
}

QString validationSummary(const ValidationRecord& record) {
    std::int64_t falls = 0, moving = 0, left = 0, lost = 0;
    for (const VariantRecord& variant : record.variants) {
        falls += variant.falls;
        moving += variant.moving;
        left += variant.left;
        lost += variant.lost;
    }
    const QString named = QStringLiteral("<b>%1</b> (%2)")
                              .arg(validationWords(record.title).toHtmlEscaped(), validationWords(record.source).toHtmlEscaped());
    if (falls == 0) {
        return named;
    }
    return ValidationWords::tr("%1: %2 falls simulated, of which %3 still moved at the end, %4 left the terrain and %5 were lost")
        .arg(named)
        .arg(falls)
        .arg(moving)
        .arg(left)
        .arg(lost);
}

QString validationTerms() {
    return ValidationWords::tr(
        "In the terms of ASME V&amp;V 20 D is what was measured, S what was simulated and E = S − D the comparison error of the "
        "means. Its interval holds it in 95 of 100 resamplings of bodies and repeats. The area between the cumulative curves says "
        "how far one would have to be moved to become the other, in brackets what chance alone makes of it. Falls that were not at "
        "rest, left the terrain or were lost are in no mean. Nothing is fitted unless the source of a value says so.");
}

}  // namespace rubble::figures
