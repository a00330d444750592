#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"

class QPainter;
class QRectF;

namespace rubble::figures {

/// A heading; numbers are given by the order: 1, 1.1. An appendix counts A, B.
struct ReportHeading {
    int level = 1;  ///< 1 or 2
    QString text;
    bool appendix = false;
};

/// Running text; simple tags (b, i, sub, sup, code) are let through, everything else must be escaped.
struct ReportText {
    QString html;
};

/// Points of a list.
struct ReportList {
    QStringList items;  ///< as ReportText
};

/// Something that must not be overlooked, beside a bar in amber.
struct ReportNotice {
    QString html;
};

/// A numbered equation and what its signs stand for.
struct ReportEquation {
    QString notation;  ///< of setFormula()
    QString words;     ///< for readers who cannot see it
    QString where;     ///< as ReportText
};

/// A table with rules above and below; the first column is to the left, others to the right unless they are words.
struct ReportTable {
    QString caption;
    QStringList columns;
    std::vector<bool> words;     ///< of each column: set to the left, broken over lines; else figures to the right
    std::vector<double> shares;  ///< of the width of each column; empty: by content
    std::vector<QStringList> rows;
    QString source;  ///< what its numbers trace to, below the table in small; empty: nothing
    bool small = false;
};

/// A picture or a drawing.
struct ReportFigure {
    QString caption;
    QString words;   ///< for readers who cannot see it
    QImage picture;  ///< null: drawn by `paint`
    std::function<void(QPainter& painter, const QRectF& area, double textHeight)> paint;
    double aspect = 1.6;  ///< width over height
    double share = 1.0;   ///< of the width of the page
    QString source;
};

using ReportBlock = std::variant<ReportHeading, ReportText, ReportList, ReportNotice, ReportEquation, ReportTable, ReportFigure>;

/// A report: what stands on its first page, and its blocks in order.
struct ReportDocument {
    QString title;
    QString subtitle;
    std::vector<std::pair<QString, QString>> facts;  ///< of the first page: "Run", "1a2b"
    QString header;                                  ///< at the top of every page but the first
    QString contents;                                ///< heading of the table of contents
    QString page;                                    ///< "page %1 of %2"
    QString figure;                                  ///< "Figure %1"
    QString table;                                   ///< "Table %1"
    QString language;                                ///< "en", "zh"
    std::vector<ReportBlock> blocks;
};

/// The headings with their numbers, in order: "2.1 Inputs".
std::vector<std::pair<int, QString>> numberedHeadings(const ReportDocument& document);

/// The whole report as one HTML page that needs nothing else: pictures, drawings and formulas are inside.
/// @param metadata  JSON of its provenance; empty: none
QByteArray reportHtml(const ReportDocument& document, const std::string& metadata);

/// Writes it as PDF: A4, table of contents with pages, header and page numbers, tags for screen readers. Atomic.
/// @param findings  get what it lacks: a report that cannot be tagged is written without
/// Throws WorldError naming the path.
void writeReportPdf(const std::string& path, const ReportDocument& document, const std::string& metadata, Findings& findings,
                    const Execution& execution = Execution());

}  // namespace rubble::figures
