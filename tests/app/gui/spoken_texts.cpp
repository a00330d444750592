#include "tests/app/gui/spoken_texts.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QRegularExpression>
#include <QWidget>
#include <algorithm>
#include <set>

#include "core/base/build.h"
#include "core/fe/fe_result.h"
#include "core/scenario/parameters.h"

namespace rubble {

namespace {

QString wayTo(const QObject& object, const QObject& window) {
    QString way;
    for (const QObject* at = &object; at != &window && at != nullptr; at = at->parent()) {
        const qsizetype place = at->parent() != nullptr ? at->parent()->children().indexOf(const_cast<QObject*>(at)) : 0;
        way.prepend(QStringLiteral("/%1:%2%3").arg(QLatin1String(at->metaObject()->className()), at->objectName()).arg(place));
    }
    return way;
}

void addModel(Texts& texts, const QString& way, const QAbstractItemModel& model) {
    for (int column = 0; column < model.columnCount(); ++column) {
        texts[way + QStringLiteral("#head%1").arg(column)] = model.headerData(column, Qt::Horizontal).toString();
        texts[way + QStringLiteral("#headtip%1").arg(column)] =
            model.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString();
        for (int row = 0; row < model.rowCount(); ++row) {
            const QModelIndex cell = model.index(row, column);
            texts[way + QStringLiteral("#%1,%2").arg(row).arg(column)] = cell.data().toString();
            texts[way + QStringLiteral("#tip%1,%2").arg(row).arg(column)] = cell.data(Qt::ToolTipRole).toString();
        }
    }
}

/// Words in Latin letters that are the same in every language: units, formats, programs, people, keys of the keyboard.
const std::set<QString>& sameEverywhere() {
    static const std::set<QString> words = [] {
        std::set<QString> list;
        const QString plain = QStringLiteral(
            "Rubble rubble cli ffmpeg Slurm slurm conf munge sinfo sacctmgr sbatch ParaView Bullet bullet Exodus II CSV PVD SVG "
            "PNG JSON VTU HDF GTX NVIDIA IoU "
            "RMS FPS "
            "VTKHDF FE MB MiB GiB "
            "kB kg mm ms "
            "min kJ MJ GJ TJ nbsp amp lt gt quot Ctrl Shift Enter Delete Esc Home End Space Tab Alt auto Auto English "
            "NAVFAC DM ACI Rockyfor Dorren Wyllie Asteriou Tsiambaos Baltay Gjelsvik Rabbat Russell Avallone Baumeister STATUS "
            "accuracy calibrate csv pair inspect frame status none EPYC AMD Intel CPU GHz Core Xeon Processor Platinum x86 Mesa "
            "LLVM bits llvmpipe "
            "NAME true false Left Right Up Down Pa exo tif tiff asc bil img hgt dt xyz grd zh CN xf px viridis cividis JPEG TIFF "
            "HEIC "
            "PDF pdf HTML html MP glTF Blender SI ft lb report run ensemble compare GeoTIFF GeoPackage GeoJSON Shapefile ESRI OBJ "
            "PLY M C E cloud photographs ASME validate survey kPa dyn cm lbf kip psi ksi psf in dpi LS DYNA OpenRadioss "
            "EN kN LAS EPSG WKT PROJ intensity red green blue class return returns time skip SHA PEM RFC RSA Ed tsq tsr");
        for (const QString& word : plain.split(u' ')) {
            list.insert(word);
        }
        // Keys and values as the case file and the command line have them.
        for (const Parameter& row : parameterTable()) {
            for (const QString& word : QString::fromUtf8(row.key.data(), static_cast<qsizetype>(row.key.size()))
                                           .split(QRegularExpression(QStringLiteral("[^A-Za-z]+")))) {
                list.insert(word);
            }
            for (const std::string_view choice : row.choices) {
                for (const QString& word : QString::fromUtf8(choice.data(), static_cast<qsizetype>(choice.size()))
                                               .split(QRegularExpression(QStringLiteral("[^A-Za-z]+")))) {
                    list.insert(word);
                }
            }
        }
        return list;
    }();
    return words;
}

}  // namespace

Texts textsOf(QWidget& window) {
    Texts texts;
    QList<QObject*> objects = window.findChildren<QObject*>();
    objects << &window;
    for (const QObject* object : objects) {
        const QString way = wayTo(*object, window);
        if (!object->isWidgetType() && !object->inherits("QAction")) {
            continue;
        }
        if (object->inherits("QTextEdit") || object->inherits("QLineEdit") ||
            object->objectName().startsWith(QLatin1String("qt_"))) {
            continue;
        }
        for (const char* property : {"text", "title", "toolTip", "accessibleName", "accessibleDescription", "placeholderText"}) {
            if (const QVariant value = object->property(property); value.typeId() == QMetaType::QString) {
                texts[way + u'.' + QLatin1String(property)] = value.toString();
            }
        }
        if (const auto* choice = qobject_cast<const QComboBox*>(object)) {
            addModel(texts, way, *choice->model());
        } else if (const auto* view = qobject_cast<const QAbstractItemView*>(object); view != nullptr && view->model() != nullptr) {
            addModel(texts, way, *view->model());
        }
    }
    return texts;
}

QStringList strangeWords(QString text, const QStringList& names) {
    static const QRegularExpression tag(QStringLiteral("<[^>]*>"));
    static const QRegularExpression path(QStringLiteral("\\S*/\\S*/\\S*|\\b[0-9a-f]{8,}\\b"));
    static const QRegularExpression word(QStringLiteral("[A-Za-z]{2,}"));
    for (const QString& name : names) {
        text.remove(name, Qt::CaseInsensitive);
    }
    text.replace(tag, QStringLiteral(" "));
    text.remove(path);
    // What Slurm itself says, and what is cited.
    static const QRegularExpression told(QStringLiteral("sinfo: .*|Xu, Lu, Guan, Ren: [^<]*"));
    text.remove(told);
    QStringList found;
    for (auto at = word.globalMatch(text); at.hasNext();) {
        const QString latin = at.next().captured();
        if (!sameEverywhere().contains(latin)) {
            found << latin;
        }
    }
    return found;
}

QStringList namesIn(const FeResult* fe) {
    QStringList names{QStringLiteral("rc-arch.exo"), QStringLiteral("rc-arch"), QStringLiteral("As computed, copy"),
                      QStringLiteral("As computed"),
                      QString::fromUtf8(buildText().data(), static_cast<qsizetype>(buildText().size()))};
    if (fe != nullptr) {
        for (const Part& part : fe->mesh().parts) {
            names << QString::fromStdString(part.name);
        }
    }
    // "deck slab under trucks" before "deck slab".
    std::sort(names.begin(), names.end(), [](const QString& a, const QString& b) { return a.size() > b.size(); });
    return names;
}

}  // namespace rubble
