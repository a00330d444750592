#include <QCoreApplication>
#include <array>

#include "app/gui/window/action_table.h"

namespace rubble {

namespace {

const std::array exportTable = {
    ActionRow{ActionId::ExportFigure,
              "export_figure",
              "Export",
              QT_TRANSLATE_NOOP("actions", "Figure of this instant…"),
              QT_TRANSLATE_NOOP("actions", "Save the views, or the arrangement of a published figure, for print: PNG, SVG or PDF"),
              "Ctrl+E",
              {}},
    ActionRow{ActionId::ExportMovie,
              "export_movie",
              "Export",
              QT_TRANSLATE_NOOP("actions", "Movie…"),
              QT_TRANSLATE_NOOP("actions", "Save the collapse as a movie: MP4 or numbered pictures"),
              "Ctrl+Shift+M",
              {}},
    ActionRow{ActionId::WriteReport, "write_report", "Export", QT_TRANSLATE_NOOP("actions", "Report…"),
              QT_TRANSLATE_NOOP("actions", "Write a report of the run as PDF and HTML"), "Ctrl+Shift+R", widgets::Glyph::Report},
    ActionRow{ActionId::ExportMap,
              "export_map",
              "Export",
              QT_TRANSLATE_NOOP("actions", "Debris map…"),
              QT_TRANSLATE_NOOP("actions", "Save where the debris of the run lies, as GeoTIFF, GeoPackage, CSV or PNG"),
              "Ctrl+Shift+D",
              {}},
    ActionRow{ActionId::SharePage,
              "share_page",
              "Export",
              QT_TRANSLATE_NOOP("actions", "Share as a page…"),
              QT_TRANSLATE_NOOP("actions",
                                "Save the run as one page that any browser opens without network, with both views and its sources"),
              "",
              {}},
    ActionRow{ActionId::ExportFragments,
              "export_fragments",
              "Export",
              QT_TRANSLATE_NOOP("actions", "Table of fragments…"),
              QT_TRANSLATE_NOOP("actions", "Save where every fragment went, as CSV"),
              "",
              {}},
    ActionRow{ActionId::ExportSelection,
              "export_selection",
              "Export",
              QT_TRANSLATE_NOOP("actions", "Table of selected fragments…"),
              QT_TRANSLATE_NOOP("actions", "Save where the selected fragments went, as CSV"),
              "Ctrl+Shift+E",
              {}},
    ActionRow{ActionId::ExportSeries,
              "export_series",
              "Export",
              QT_TRANSLATE_NOOP("actions", "Series for ParaView…"),
              QT_TRANSLATE_NOOP("actions", "Save fragments and active structure over time, as PVD"),
              "",
              {}},
    ActionRow{ActionId::ExportVtkhdf,
              "export_vtkhdf",
              "Export",
              QT_TRANSLATE_NOOP("actions", "Series in one file…"),
              QT_TRANSLATE_NOOP("actions", "Save fragments and active structure over time for ParaView 5.12 and newer, as VTKHDF"),
              "",
              {}},
    ActionRow{ActionId::ExportGltf,
              "export_gltf",
              "Export",
              QT_TRANSLATE_NOOP("actions", "Fragments as glTF…"),
              QT_TRANSLATE_NOOP("actions", "Save the fragments with their motion for Blender and web viewers, as glTF"),
              "",
              {}},
    ActionRow{ActionId::ExportView,
              "export_view",
              "Export",
              QT_TRANSLATE_NOOP("actions", "View…"),
              QT_TRANSLATE_NOOP("actions", "Save what the views show and how, for rubble-cli figure and for later"),
              "",
              {}},
    ActionRow{ActionId::ImportView,
              "import_view",
              "Export",
              QT_TRANSLATE_NOOP("actions", "Open a view…"),
              QT_TRANSLATE_NOOP("actions", "Look at the model as a saved view did"),
              "",
              {}},
};

}  // namespace

std::span<const ActionRow> exportActions() {
    return exportTable;
}

}  // namespace rubble
