#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QFontMetricsF>
#include <QPainter>
#include <QPdfWriter>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextDocumentFragment>
#include <QTextLayout>

#include <algorithm>
#include <cmath>
#include <memory>

#include "widgets/figures/figure_file.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/report/formula.h"
#include "widgets/figures/report/report_document.h"
#include "widgets/figures/report/tagged_pdf.h"

namespace rubble::figures {
namespace {

constexpr int dotsPerInch = 300;
constexpr double dot = dotsPerInch / 72.0;  // a point
constexpr double pageWidth = 595.0 * dot;   // A4
constexpr double pageHeight = 842.0 * dot;
constexpr double left = 71.0 * dot;
constexpr double right = 62.0 * dot;
constexpr double top = 74.0 * dot;
constexpr double bottom = 68.0 * dot;
constexpr double textWidth = pageWidth - left - right;
constexpr double bodyPoints = 9.5;
constexpr double notePoints = 8.0;
constexpr double sourcePoints = 6.5;
constexpr std::size_t leastRows = 3;                                 // of a table that stand together on a page
constexpr double longestWhole = 0.45 * (pageHeight - top - bottom);  // of a table that is not broken

const QColor ink(0x1f, 0x24, 0x28);
const QColor grey(0x5d, 0x66, 0x6e);

QFont fontOf(double points, bool bold = false) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(std::max(1, static_cast<int>(std::lround(points * dot))));
    font.setBold(bold);
    return font;
}

/// Rich text of a width, ready to be painted.
std::unique_ptr<QTextDocument> textOf(const QString& html, double points, double wide, const QColor& colour = ink,
                                      Qt::Alignment alignment = Qt::AlignLeft) {
    auto text = std::make_unique<QTextDocument>();
    text->setDefaultFont(fontOf(points));
    text->setDocumentMargin(0.0);
    QTextOption option(alignment);
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    text->setDefaultTextOption(option);
    text->setDefaultStyleSheet(QStringLiteral("body{color:%1} code{font-family:'DejaVu Sans Mono';font-size:%2px}")
                                   .arg(colour.name())
                                   .arg(static_cast<int>(std::lround(0.88 * points * dot))));
    text->setHtml(QStringLiteral("<body>") + html + QStringLiteral("</body>"));
    text->setTextWidth(wide);
    return text;
}

/// One row of the table of contents, once its page is known.
struct ContentsRow {
    int level = 1;
    QString text;
    int page = 0;
};

/// Sets the blocks on pages. Goes twice over the document: the first time to learn the pages of headings and their number.
class PdfSetter {
public:
    PdfSetter(const ReportDocument& document, QPdfWriter& writer, std::vector<ContentsRow> contents, int pages)
        : m_document(document),
          m_writer(writer),
          m_painter(&writer),
          m_contents(std::move(contents)),
          m_pages(pages),
          m_headings(numberedHeadings(document)) {}

    void run(const Execution& execution) {
        setFirstPage();
        setContents();
        newPage();
        for (std::size_t k = 0; k < m_document.blocks.size(); ++k) {
            execution.check();
            m_next = k + 1 < m_document.blocks.size() ? &m_document.blocks[k + 1] : nullptr;
            std::visit([this](const auto& each) { set(each); }, m_document.blocks[k]);
        }
        m_painter.end();
    }
    const std::vector<ContentsRow>& found() const { return m_found; }
    int pages() const { return m_page; }
    const PdfTags& tags() const { return m_tags; }

private:
    double room() const { return pageHeight - bottom - m_y; }
    void need(double height) {
        if (height > room() && m_y > top + 1.0) {
            newPage();
        }
    }
    void newPage() {
        m_writer.newPage();
        ++m_page;
        m_y = top;
        m_painter.setPen(grey);
        m_painter.setFont(fontOf(7.5));
        const QRectF head(left, 40.0 * dot, textWidth, 14.0 * dot);
        m_painter.drawText(head, static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter), m_document.header);
        const QRectF foot(left, pageHeight - 46.0 * dot, textWidth, 14.0 * dot);
        m_painter.drawText(foot, static_cast<int>(Qt::AlignRight | Qt::AlignVCenter), m_document.page.arg(m_page).arg(m_pages));
        m_painter.setPen(QPen(QColor(0xb9, 0xc0, 0xc6), 0.5 * dot));
        m_painter.drawLine(QPointF(left, 56.0 * dot), QPointF(left + textWidth, 56.0 * dot));
    }
    void paint(QTextDocument& text, double x) {
        m_painter.save();
        m_painter.translate(x, m_y);
        QAbstractTextDocumentLayout::PaintContext context;
        context.palette.setColor(QPalette::Text, ink);
        text.documentLayout()->draw(&m_painter, context);
        m_painter.restore();
    }
    /// Paints text as an element of the structure.
    void paintAs(const char* type, QTextDocument& text, double x) {
        // Lines are painted one by one, and what is read would run together where they meet.
        const bool lines = text.blockCount() > 1 || text.firstBlock().layout()->lineCount() > 1;
        const PdfTag tag(m_tags, type, {}, lines ? text.toPlainText() : QString());
        if (!text.isEmpty()) {
            const PdfMark mark(m_tags, m_painter);
            paint(text, x);
        }
    }
    void drawAs(const char* type, const QRectF& box, Qt::Alignment alignment, const QString& text) {
        const PdfTag tag(m_tags, type);
        const PdfMark mark(m_tags, m_painter);
        m_painter.drawText(box, static_cast<int>(alignment), text);
    }
    /// Sets running text; it is not broken over pages.
    void setRich(const char* type, const QString& html, double points, double indent, double after, const QColor& colour = ink) {
        const auto text = textOf(html, points, textWidth - indent, colour);
        need(text->size().height());
        paintAs(type, *text, left + indent);
        m_y += text->size().height() + after;
    }

    void setFirstPage() {
        m_y = 150.0 * dot;
        m_painter.fillRect(QRectF(left, 128.0 * dot, 42.0 * dot, 4.0 * dot), palette(render::Theme::Print).fragment);
        setRich("H1", QStringLiteral("<b>%1</b>").arg(m_document.title.toHtmlEscaped()), 24.0, 0.0, 8.0 * dot);
        setRich("P", m_document.subtitle.toHtmlEscaped(), 12.0, 0.0, 34.0 * dot, grey);
        const PdfTag list(m_tags, "L");
        for (const auto& [name, value] : m_document.facts) {
            const PdfTag item(m_tags, "LI");
            const double start = m_y;
            const auto label = textOf(name.toHtmlEscaped(), bodyPoints, 120.0 * dot, grey);
            paintAs("Lbl", *label, left);
            setRich("LBody", value, bodyPoints, 128.0 * dot, 5.0 * dot);
            m_y = std::max(m_y, start + label->size().height() + 5.0 * dot);
        }
    }
    void setContents() {
        newPage();
        setRich("H2", QStringLiteral("<b>%1</b>").arg(m_document.contents.toHtmlEscaped()), 15.0, 0.0, 10.0 * dot);
        const PdfTag list(m_tags, "TOC");
        for (const ContentsRow& row : m_contents) {
            const QFont font = fontOf(bodyPoints, row.level == 1);
            const double line = QFontMetricsF(font).height() * (row.level == 1 ? 1.5 : 1.2);
            need(line);
            m_painter.setFont(font);
            m_painter.setPen(ink);
            const double indent = row.level == 1 ? 0.0 : 16.0 * dot;
            const QRectF box(left + indent, m_y, textWidth - indent, line);
            const PdfTag item(m_tags, "TOCI");
            drawAs("Reference", box, Qt::AlignLeft | Qt::AlignBottom, row.text);
            drawAs("Span", box, Qt::AlignRight | Qt::AlignBottom, QString::number(row.page));
            m_y += line;
        }
    }

    // Height that a block takes before it can go on on another page.
    double least(const ReportHeading& heading) const {
        return (heading.level == 1 ? 60.0 : 46.0) * dot + 3.0 * QFontMetricsF(fontOf(bodyPoints)).height();
    }
    double least(const ReportText& text) const { return textOf(text.html, bodyPoints, textWidth)->size().height(); }
    double least(const ReportList& list) const {
        return list.items.empty() ? 0.0 : textOf(list.items.front(), bodyPoints, textWidth - 14.0 * dot)->size().height();
    }
    double least(const ReportNotice& notice) const {
        return textOf(notice.html, bodyPoints, textWidth - 24.0 * dot)->size().height() + 14.0 * dot;
    }
    double least(const ReportEquation&) const { return 80.0 * dot; }
    double least(const ReportFigure& figure) const { return heightOf(figure) + 60.0 * dot; }
    double least(const ReportTable& table) const { return cellsOf(table, 1).together(); }

    void set(const ReportHeading& heading) {
        const bool first = heading.level == 1;
        const double points = first ? 15.0 : 11.0;
        const QString text = m_headings[m_heading].second;
        // A heading does not stand alone at the foot of a page: what begins below it fits there too.
        const double below = m_next != nullptr ? std::visit([this](const auto& each) { return least(each); }, *m_next) : 0.0;
        need((first ? 60.0 : 46.0) * dot + below);
        if (m_y > top + 1.0) {
            m_y += (first ? 20.0 : 11.0) * dot;
        }
        m_found.push_back({heading.level, text, m_page});
        m_tags.addBookmark(heading.level, text.simplified(), static_cast<std::size_t>(m_page - 1));
        ++m_heading;
        setRich(first ? "H2" : "H3", QStringLiteral("<b>%1</b>").arg(text.toHtmlEscaped()), points, 0.0, (first ? 7.0 : 4.0) * dot);
    }
    void set(const ReportText& text) { setRich("P", text.html, bodyPoints, 0.0, 6.0 * dot); }
    void set(const ReportList& list) {
        const PdfTag tag(m_tags, "L");
        for (const QString& item : list.items) {
            const auto text = textOf(item, bodyPoints, textWidth - 14.0 * dot);
            need(text->size().height());
            const PdfTag itemTag(m_tags, "LI");
            m_painter.setPen(Qt::NoPen);
            m_painter.setBrush(ink);
            {
                const PdfTag label(m_tags, "Lbl", {}, QStringLiteral("•"));
                const PdfMark mark(m_tags, m_painter);
                m_painter.drawEllipse(QPointF(left + 4.0 * dot, m_y + 6.2 * dot), 1.4 * dot, 1.4 * dot);
            }
            paintAs("LBody", *text, left + 14.0 * dot);
            m_y += text->size().height() + 3.0 * dot;
        }
        m_y += 4.0 * dot;
    }
    void set(const ReportNotice& notice) {
        const auto text = textOf(notice.html, bodyPoints, textWidth - 24.0 * dot);
        const double height = text->size().height() + 14.0 * dot;
        need(height);
        m_painter.fillRect(QRectF(left, m_y, textWidth, height), QColor(0xfd, 0xf6, 0xe6));
        m_painter.fillRect(QRectF(left, m_y, 3.0 * dot, height), QColor(0xe6, 0x9f, 0x00));
        m_y += 7.0 * dot;
        paintAs("P", *text, left + 14.0 * dot);
        m_y += height - 7.0 * dot + 9.0 * dot;
    }
    void set(const ReportEquation& equation) {
        const SetFormula formula = setFormula(equation.notation, 11.5 * dot);
        const double height = formula.ascent + formula.descent;
        need(height + 40.0 * dot);
        m_y += 5.0 * dot;
        const QString number = QStringLiteral("(%1)").arg(++m_equation);
        const PdfTag line(m_tags, "P");
        {
            const PdfTag tag(m_tags, "Formula", equation.words);
            const PdfMark mark(m_tags, m_painter);
            m_painter.save();
            m_painter.setRenderHint(QPainter::Antialiasing);
            m_painter.translate(left + 26.0 * dot, m_y + formula.ascent);
            m_painter.fillPath(formula.outline, ink);
            m_painter.restore();
        }
        m_painter.setFont(fontOf(bodyPoints));
        m_painter.setPen(ink);
        drawAs("Span", QRectF(left, m_y, textWidth, height), Qt::AlignRight | Qt::AlignVCenter, number);
        m_y += height + 8.0 * dot;
        if (!equation.where.isEmpty()) {
            setRich("P", equation.where, bodyPoints, 0.0, 7.0 * dot);
        }
    }

    static double aspectOf(const ReportFigure& figure) {
        return figure.picture.isNull() ? figure.aspect : static_cast<double>(figure.picture.width()) / figure.picture.height();
    }
    static double heightOf(const ReportFigure& figure) {
        return std::min(figure.share * textWidth / aspectOf(figure), 0.8 * (pageHeight - top - bottom));
    }

    void set(const ReportFigure& figure) {
        const double aspect = aspectOf(figure);
        const double high = heightOf(figure);
        const auto caption =
            textOf(QStringLiteral("<b>%1.</b> %2").arg(m_document.figure.arg(++m_figure), figure.caption), notePoints, textWidth);
        const auto source = textOf(figure.source, sourcePoints, textWidth, grey);
        const double sourceHeight = figure.source.isEmpty() ? 0.0 : source->size().height() + 2.0 * dot;
        need(high + caption->size().height() + sourceHeight + 20.0 * dot);
        m_y += 6.0 * dot;
        const QRectF area(left + 0.5 * (textWidth - high * aspect), m_y, high * aspect, high);
        // The caption stands beside the figure: what is inside of one with an alternative text is not read.
        const PdfTag both(m_tags, "Div");
        paintFigure(figure, area);
        m_y += high + 5.0 * dot;
        paintAs("Caption", *caption, left);
        m_y += caption->size().height() + 2.0 * dot;
        if (sourceHeight > 0.0) {
            paintAs("P", *source, left);
            m_y += sourceHeight;
        }
        m_y += 9.0 * dot;
    }

    void paintFigure(const ReportFigure& figure, const QRectF& area) {
        // Words that are the caption have its tags.
        const PdfTag tag(m_tags, "Figure", QTextDocumentFragment::fromHtml(figure.words).toPlainText());
        const PdfMark mark(m_tags, m_painter);
        m_painter.save();
        m_painter.setRenderHint(QPainter::SmoothPixmapTransform);
        if (figure.picture.isNull()) {
            m_painter.setRenderHint(QPainter::Antialiasing);
            figure.paint(m_painter, area, notePoints * dot);
        } else {
            m_painter.drawImage(area, figure.picture);
        }
        m_painter.restore();
    }

    /// Widths of the columns: as asked for, else by the longest word of each with the rest shared out by length.
    static std::vector<double> columnWidths(const ReportTable& table, double points) {
        const auto columns = static_cast<std::size_t>(table.columns.size());
        std::vector<double> widths(columns, 0.0);
        if (table.shares.size() == columns) {
            double sum = 0.0;
            for (const double share : table.shares) {
                sum += share;
            }
            for (std::size_t c = 0; c < columns; ++c) {
                widths[c] = textWidth * table.shares[c] / sum;
            }
            return widths;
        }
        const QFontMetricsF metrics(fontOf(points, true));
        double sum = 0.0;
        for (std::size_t c = 0; c < columns; ++c) {
            const auto column = static_cast<qsizetype>(c);
            widths[c] = metrics.horizontalAdvance(table.columns[column]);
            for (const QStringList& row : table.rows) {
                if (column < row.size()) {
                    widths[c] = std::max(widths[c], metrics.horizontalAdvance(row[column]));
                }
            }
            widths[c] = std::min(widths[c], 0.45 * textWidth) + 10.0 * dot;
            sum += widths[c];
        }
        for (double& each : widths) {
            each *= textWidth / sum;
        }
        return widths;
    }

    struct RowCells {
        std::vector<std::unique_ptr<QTextDocument>> cells;
        double height = 0.0;
    };
    static RowCells rowOf(const ReportTable& table, const QStringList& row, const std::vector<double>& widths, double points,
                          bool bold) {
        RowCells made;
        const double pad = 4.0 * dot;
        for (std::size_t c = 0; c < widths.size(); ++c) {
            const bool words = c < table.words.size() ? bool(table.words[c]) : c == 0;
            const QString text = static_cast<qsizetype>(c) < row.size() ? row[static_cast<qsizetype>(c)] : QString();
            made.cells.push_back(textOf(bold ? QStringLiteral("<b>%1</b>").arg(text) : text, points, widths[c] - 2.0 * pad, ink,
                                        words ? Qt::AlignLeft : Qt::AlignRight));
            made.height = std::max(made.height, made.cells.back()->size().height());
        }
        made.height += 4.0 * dot;
        return made;
    }
    /// @param type  of its cells; null: they are no part of the structure
    void paintRow(const RowCells& row, const std::vector<double>& widths, const char* type) {
        const double pad = 4.0 * dot;
        const double start = m_y;
        double x = left;
        m_y += 2.0 * dot;
        for (std::size_t c = 0; c < row.cells.size(); ++c) {
            if (type != nullptr) {
                paintAs(type, *row.cells[c], x + pad);
            } else {
                paint(*row.cells[c], x + pad);
            }
            x += widths[c];
        }
        m_y = start + row.height;
    }
    void rule(double thickness) { m_painter.fillRect(QRectF(left, m_y - 0.5 * thickness * dot, textWidth, thickness * dot), ink); }

    /// A table, ready to be painted.
    struct TableCells {
        std::vector<double> widths;
        std::unique_ptr<QTextDocument> caption;
        RowCells head;
        std::vector<RowCells> rows;

        double heightOf(std::size_t from, std::size_t to) const {
            double height = 0.0;
            for (std::size_t k = from; k < std::min(to, rows.size()); ++k) {
                height += rows[k].height;
            }
            return height;
        }
        /// What stands on one page: all of a table that is not long, else its first rows.
        double together() const {
            const double before = caption->size().height() + head.height + 24.0 * dot;
            const double whole = before + heightOf(0, rows.size());
            return whole <= longestWhole ? whole : before + heightOf(0, leastRows);
        }
    };
    static double pointsOf(const ReportTable& table) { return table.small ? 7.0 : notePoints; }
    TableCells cellsOf(const ReportTable& table, int number) const {
        const double points = pointsOf(table);
        TableCells made;
        made.widths = columnWidths(table, points);
        made.caption =
            textOf(QStringLiteral("<b>%1.</b> %2").arg(m_document.table.arg(number), table.caption), notePoints, textWidth);
        QStringList names = table.columns;
        // A unit such as m/s stays in one line.
        names.replaceInStrings(QStringLiteral("/"), QStringLiteral("/\u2060"));
        made.head = rowOf(table, names, made.widths, points, true);
        for (const QStringList& each : table.rows) {
            made.rows.push_back(rowOf(table, each, made.widths, points, false));
        }
        return made;
    }

    void set(const ReportTable& table) {
        const TableCells cells = cellsOf(table, ++m_table);
        need(cells.together());
        m_y += 6.0 * dot;
        {
            const PdfTag tag(m_tags, "Table");
            setRows(cells);
        }
        m_y += 4.0 * dot;
        if (!table.source.isEmpty()) {
            setRich("P", table.source, sourcePoints, 0.0, 0.0, grey);
        }
        m_y += 11.0 * dot;
    }
    void setRows(const TableCells& cells) {
        const auto& [widths, caption, head, rows] = cells;
        paintAs("Caption", *caption, left);
        m_y += caption->size().height() + 4.0 * dot;
        setHead(cells, "TH");
        const PdfTag body(m_tags, "TBody");
        std::size_t onPage = 0;
        for (std::size_t k = 0; k < rows.size(); ++k, ++onPage) {
            // The last rows stay together, so that none stands alone on the next page.
            const bool lastFew = onPage >= leastRows && k + leastRows == rows.size();
            if (cells.heightOf(k, lastFew ? rows.size() : k + 1) > room() - 4.0 * dot) {
                rule(1.0);
                newPage();
                setHead(cells, nullptr);
                onPage = 0;
            }
            const PdfTag tag(m_tags, "TR");
            paintRow(rows[k], widths, "TD");
        }
        m_y += 1.0 * dot;
        rule(1.0);
    }
    /// The head of a table. On further pages it is repeated, and not read again.
    void setHead(const TableCells& cells, const char* type) {
        rule(1.0);
        if (type != nullptr) {
            const PdfTag head(m_tags, "THead");
            const PdfTag row(m_tags, "TR");
            paintRow(cells.head, cells.widths, type);
        } else {
            paintRow(cells.head, cells.widths, nullptr);
        }
        rule(0.5);
        m_y += 1.0 * dot;
    }

    const ReportDocument& m_document;
    QPdfWriter& m_writer;
    QPainter m_painter;
    PdfTags m_tags;
    std::vector<ContentsRow> m_contents;
    int m_pages;
    std::vector<std::pair<int, QString>> m_headings;
    std::vector<ContentsRow> m_found;
    const ReportBlock* m_next = nullptr;  ///< that follows what is set
    std::size_t m_heading = 0;
    int m_page = 1;
    double m_y = top;
    int m_equation = 0;
    int m_table = 0;
    int m_figure = 0;
};

}  // namespace

void writeReportPdf(const std::string& path, const ReportDocument& document, const std::string& metadata, Findings& findings,
                    const Execution& execution) {
    std::vector<ContentsRow> contents;
    for (const auto& [level, text] : numberedHeadings(document)) {
        contents.push_back({level, text, 0});
    }
    int pages = 0;
    QByteArray pdf;
    PdfTags tags;
    // Twice: the pages of the headings are known after the first time, and do not depend on what stands in the contents.
    for (int pass = 0; pass < 2; ++pass) {
        pdf.clear();
        QBuffer buffer(&pdf);
        buffer.open(QIODevice::WriteOnly);
        QPdfWriter writer(&buffer);
        writer.setResolution(dotsPerInch);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageMargins(QMarginsF());
        writer.setTitle(document.title);
        tagPdf(writer, metadata);
        PdfSetter setter(document, writer, contents, pages);
        setter.run(execution);
        contents = setter.found();
        pages = setter.pages();
        tags = setter.tags();
    }
    writeBytes(path, taggedPdf(pdf, tags, document.language, findings));
}

}  // namespace rubble::figures
