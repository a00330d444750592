#include <QBuffer>
#include <QPainter>
#include <QSvgGenerator>

#include "widgets/figures/report/formula.h"
#include "widgets/figures/report/report_document.h"

namespace rubble::figures {
namespace {

constexpr std::size_t shortTable = 12;  // rows; it is not broken in print
constexpr const char* sheet = R"(
:root{color-scheme:light}
body{font:11pt/1.5 "DejaVu Sans","Noto Sans","Helvetica Neue",Arial,"WenQuanYi Micro Hei",sans-serif;color:#1f2428;background:#fff;
max-width:46rem;margin:2.5rem auto;padding:0 1.2rem}
h1{font-size:1.9rem;line-height:1.2;margin:0 0 .3rem}
.subtitle{color:#5d666e;font-size:1.1rem;margin:0 0 1.6rem}
h2{font-size:1.3rem;margin:2.6rem 0 .6rem}h3{font-size:1.05rem;margin:1.7rem 0 .4rem}
p{margin:.5rem 0}ul{margin:.4rem 0;padding-left:1.3rem}li{margin:.2rem 0}
code{font-family:"DejaVu Sans Mono",monospace;font-size:.86em;overflow-wrap:anywhere}
table{border-collapse:collapse;width:100%;border-top:1.5pt solid #1f2428;border-bottom:1.5pt solid #1f2428;font-size:.88rem}
table.small{font-size:.78rem}
th{border-bottom:.75pt solid #1f2428;font-weight:600}th,td{padding:.22rem .5rem;text-align:right;vertical-align:top;
font-variant-numeric:tabular-nums}th.w,td.w{text-align:left;overflow-wrap:break-word}
figure{margin:1.3rem 0}figure>svg,figure>img{max-width:100%;height:auto;display:block;margin:0 auto}
figcaption{font-size:.85rem;margin:.4rem 0;color:#1f2428}.table figcaption{margin:0 0 .35rem}
.source{font-size:.72rem;color:#5d666e;margin:.3rem 0 0;overflow-wrap:anywhere}
.notice{border-left:4px solid #e69f00;background:#fdf6e6;padding:.5rem .9rem;margin:.9rem 0}
.equation{display:flex;align-items:center;justify-content:space-between;gap:1rem;margin:1rem 0 1rem 2rem}
.equation svg{min-width:0;max-width:100%}
.where{color:#1f2428;font-size:.92rem}
dl{display:grid;grid-template-columns:max-content 1fr;gap:.25rem 1.2rem;border-top:.75pt solid #b9c0c6;padding-top:.8rem}
dt{color:#5d666e}dd{margin:0;overflow-wrap:anywhere}
nav{margin:1.6rem 0}nav ol{list-style:none;padding:0}nav .l2{padding-left:1.6rem}nav a{color:inherit;text-decoration:none}
nav a:hover{text-decoration:underline}
@media screen and (max-width:46rem){figure.table{overflow-x:auto}.equation{margin-left:0}}
@page{size:A4;margin:18mm 16mm}
@media print{:root{font-size:13px}body{max-width:none;margin:0;padding:0;font-size:10pt}h2,h3{break-after:avoid}
.table figcaption{break-after:avoid}figcaption,figure:not(.table),figure.short,.notice,tr{break-inside:avoid}
thead{display:table-header-group}.source{break-before:avoid}}
)";

QString imageTag(const QImage& picture, const QString& words) {
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    picture.save(&buffer, "PNG");
    return QStringLiteral("<img alt=\"%1\" src=\"data:image/png;base64,%2\">")
        .arg(words.toHtmlEscaped(), QString::fromLatin1(png.toBase64()));
}

/// A drawing as an SVG inside the page.
QString drawingTag(const ReportFigure& figure) {
    constexpr int width = 900;
    const int height = static_cast<int>(width / figure.aspect);
    QByteArray svg;
    {
        QBuffer buffer(&svg);
        QSvgGenerator generator;
        generator.setOutputDevice(&buffer);
        generator.setSize({width, height});
        generator.setViewBox(QRect(0, 0, width, height));
        generator.setResolution(96);
        // Qt 6.4 writes a title as it is given.
        generator.setTitle(figure.words.toHtmlEscaped());
        generator.setDescription(QString());
        QPainter painter(&generator);
        figure.paint(painter, QRectF(0, 0, width, height), 15.0);
    }
    const qsizetype start = svg.indexOf("<svg");
    QString tag = QString::fromUtf8(svg.mid(start < 0 ? 0 : start));
    return tag.replace(0, 4, QStringLiteral("<svg role=\"img\" aria-label=\"%1\"").arg(figure.words.toHtmlEscaped()));
}

/// Writes the blocks one after the other and counts what is counted.
class Page {
public:
    explicit Page(const ReportDocument& document) : m_document(document), m_headings(numberedHeadings(document)) {}

    QString body() {
        for (const ReportBlock& block : m_document.blocks) {
            std::visit([this](const auto& each) { add(each); }, block);
        }
        return m_html;
    }
    QString contents() const {
        QString list;
        for (std::size_t i = 0; i < m_headings.size(); ++i) {
            list += QStringLiteral("<li class=\"l%1\"><a href=\"#s%2\">%3</a></li>\n")
                        .arg(m_headings[i].first)
                        .arg(i)
                        .arg(m_headings[i].second.toHtmlEscaped());
        }
        return QStringLiteral("<nav><h2>%1</h2><ol>\n%2</ol></nav>\n").arg(m_document.contents.toHtmlEscaped(), list);
    }

private:
    void add(const ReportHeading& heading) {
        m_html += QStringLiteral("<h%1 id=\"s%2\">%3</h%1>\n")
                      .arg(heading.level + 1)
                      .arg(m_heading)
                      .arg(m_headings[m_heading].second.toHtmlEscaped());
        ++m_heading;
    }
    void add(const ReportText& text) { m_html += QStringLiteral("<p>") + text.html + QStringLiteral("</p>\n"); }
    void add(const ReportList& list) {
        m_html += QStringLiteral("<ul>\n");
        for (const QString& item : list.items) {
            m_html += QStringLiteral("<li>") + item + QStringLiteral("</li>\n");
        }
        m_html += QStringLiteral("</ul>\n");
    }
    void add(const ReportNotice& notice) {
        m_html += QStringLiteral("<div class=\"notice\">") + notice.html + QStringLiteral("</div>\n");
    }
    void add(const ReportEquation& equation) {
        m_html += QStringLiteral("<div class=\"equation\">") +
                  QString::fromUtf8(formulaSvg(equation.notation, 17.0, equation.words)) +
                  QStringLiteral("<span>(%1)</span></div>\n").arg(++m_equation);
        if (!equation.where.isEmpty()) {
            m_html += QStringLiteral("<p class=\"where\">") + equation.where + QStringLiteral("</p>\n");
        }
    }
    void add(const ReportTable& table) {
        const auto cell = [&](const char* tag, std::size_t column, const QString& text) {
            const bool words = column < table.words.size() ? bool(table.words[column]) : column == 0;
            const QString scope = qstrcmp(tag, "th") == 0 ? QStringLiteral(" scope=\"col\"") : QString();
            return QStringLiteral("<%1%2%3>%4</%1>")
                .arg(QLatin1String(tag), scope, words ? QStringLiteral(" class=\"w\"") : QString(), text);
        };
        m_html +=
            QStringLiteral("<figure class=\"table%4\"><figcaption><b>%1.</b> %2</figcaption>\n<table%3><thead><tr>")
                .arg(m_document.table.arg(++m_table), table.caption, table.small ? QStringLiteral(" class=\"small\"") : QString(),
                     table.rows.size() <= shortTable ? QStringLiteral(" short") : QString());
        for (qsizetype c = 0; c < table.columns.size(); ++c) {
            m_html += cell("th", static_cast<std::size_t>(c), table.columns[c]);
        }
        m_html += QStringLiteral("</tr></thead><tbody>\n");
        for (const QStringList& row : table.rows) {
            m_html += QStringLiteral("<tr>");
            for (qsizetype c = 0; c < row.size(); ++c) {
                m_html += cell("td", static_cast<std::size_t>(c), row[c]);
            }
            m_html += QStringLiteral("</tr>\n");
        }
        m_html += QStringLiteral("</tbody></table>") + source(table.source) + QStringLiteral("</figure>\n");
    }
    void add(const ReportFigure& figure) {
        m_html += QStringLiteral("<figure>") +
                  (figure.picture.isNull() ? drawingTag(figure) : imageTag(figure.picture, figure.words)) +
                  QStringLiteral("<figcaption><b>%1.</b> %2</figcaption>").arg(m_document.figure.arg(++m_figure), figure.caption) +
                  source(figure.source) + QStringLiteral("</figure>\n");
    }
    static QString source(const QString& text) {
        return text.isEmpty() ? QString() : QStringLiteral("<p class=\"source\">%1</p>").arg(text);
    }

    const ReportDocument& m_document;
    std::vector<std::pair<int, QString>> m_headings;
    QString m_html;
    std::size_t m_heading = 0;
    int m_equation = 0;
    int m_table = 0;
    int m_figure = 0;
};

}  // namespace

std::vector<std::pair<int, QString>> numberedHeadings(const ReportDocument& document) {
    std::vector<std::pair<int, QString>> headings;
    int first = 0;
    int appendix = 0;
    int second = 0;
    QString number;
    for (const ReportBlock& block : document.blocks) {
        const auto* heading = std::get_if<ReportHeading>(&block);
        if (heading == nullptr) {
            continue;
        }
        if (heading->level == 1) {
            number = heading->appendix ? QString(QChar(static_cast<char16_t>('A' + appendix++))) : QString::number(++first);
            second = 0;
            headings.emplace_back(1, number + QStringLiteral("  ") + heading->text);
        } else {
            headings.emplace_back(2, QStringLiteral("%1.%2  %3").arg(number).arg(++second).arg(heading->text));
        }
    }
    return headings;
}

QByteArray reportHtml(const ReportDocument& document, const std::string& metadata) {
    Page page(document);
    QString html = QStringLiteral(
                       "<!DOCTYPE html>\n<html lang=\"%1\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>%2</title>\n"
                       "<style>%3</style>\n")
                       .arg(document.language, document.title.toHtmlEscaped(), QString::fromUtf8(sheet));
    if (!metadata.empty()) {
        // Inside a script nothing is read as markup but its end.
        QString json = QString::fromStdString(metadata);
        html += QStringLiteral("<script type=\"application/json\" id=\"rubble-provenance\">") +
                json.replace(QStringLiteral("</"), QStringLiteral("<\\/")) + QStringLiteral("</script>\n");
    }
    html += QStringLiteral("</head>\n<body>\n<h1>%1</h1>\n<p class=\"subtitle\">%2</p>\n<dl>\n")
                .arg(document.title.toHtmlEscaped(), document.subtitle.toHtmlEscaped());
    for (const auto& [name, value] : document.facts) {
        html += QStringLiteral("<dt>%1</dt><dd>%2</dd>\n").arg(name.toHtmlEscaped(), value);
    }
    html += QStringLiteral("</dl>\n");
    const QString body = page.body();
    html += page.contents() + body + QStringLiteral("</body>\n</html>\n");
    return html.toUtf8();
}

}  // namespace rubble::figures
