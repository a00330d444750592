#include "widgets/figures/report/formula.h"

#include <QFont>
#include <QFontMetricsF>
#include <QHash>
#include <QTransform>

#include <algorithm>

namespace rubble::figures {
namespace {

constexpr double scriptShare = 0.7;

/// What a name stands for; the ones with spaces around them are relations and operators.
const QHash<QString, QString>& signs() {
    static const QHash<QString, QString> table{
        {"rho", "ρ"},     {"omega", "ω"},  {"sigma", "σ"}, {"Delta", "Δ"}, {"theta", "θ"}, {"mu", "μ"},     {"xi", "ξ"},
        {"times", " × "}, {"cdot", " · "}, {"le", " ≤ "},  {"ge", " ≥ "},  {"cap", " ∩ "}, {"cup", " ∪ "},  {"approx", " ≈ "},
        {"in", " ∈ "},    {"ldots", "…"},  {"pm", " ± "},  {"min", "min"}, {"max", "max"}, {"quad", "   "}, {",", " "}};
    return table;
}

/// Sets a notation box by box from left to right.
class Typesetter {
public:
    explicit Typesetter(const QString& notation) : m_text(notation) {}

    SetFormula run(double size) { return row(size, QChar()); }

private:
    static QFont fontOf(bool italic, bool bold) {
        QFont font(QStringLiteral("DejaVu Serif"));
        // Set large and made smaller: outlines keep their shape, hinting has no say.
        font.setPixelSize(100);
        font.setItalic(italic);
        font.setBold(bold);
        return font;
    }

    static SetFormula letters(const QString& text, double size, bool italic, bool bold) {
        const QFont font = fontOf(italic, bold);
        const QFontMetricsF metrics(font);
        const double scale = size / 100.0;
        QPainterPath path;
        path.addText(0.0, 0.0, font, text);
        SetFormula set;
        set.outline = QTransform::fromScale(scale, scale).map(path);
        set.width = scale * metrics.horizontalAdvance(text);
        const QRectF box = set.outline.boundingRect();
        set.ascent = std::max(0.0, -box.top());
        set.descent = std::max(0.0, box.bottom());
        return set;
    }

    static void place(SetFormula& whole, const SetFormula& part, double x, double y) {
        whole.outline.addPath(part.outline.translated(x, y));
        whole.ascent = std::max(whole.ascent, part.ascent - y);
        whole.descent = std::max(whole.descent, part.descent + y);
    }
    static void append(SetFormula& whole, const SetFormula& part) {
        place(whole, part, whole.width, 0.0);
        whole.width += part.width;
    }

    bool atEnd() const { return m_at >= m_text.size(); }
    QChar peek() const { return m_text[m_at]; }

    /// A group in braces, or the next sign alone.
    SetFormula group(double size) {
        if (!atEnd() && peek() == u'{') {
            ++m_at;
            return row(size, u'}');
        }
        return atom(size);
    }

    SetFormula row(double size, QChar close) {
        SetFormula whole;
        while (!atEnd()) {
            if (!close.isNull() && peek() == close) {
                ++m_at;
                break;
            }
            append(whole, scripted(size));
        }
        return whole;
    }

    /// An atom with what stands above and below its right side.
    SetFormula scripted(double size) {
        m_tall = false;
        SetFormula base = atom(size);
        const bool tall = m_tall;
        SetFormula below, above;
        bool hasBelow = false, hasAbove = false;
        while (!atEnd() && (peek() == u'_' || peek() == u'^')) {
            const bool sub = peek() == u'_';
            ++m_at;
            (sub ? below : above) = group(scriptShare * size);
            (sub ? hasBelow : hasAbove) = true;
        }
        if (tall && (hasBelow || hasAbove)) {
            return stacked(base, hasBelow ? &below : nullptr, hasAbove ? &above : nullptr, size);
        }
        const double x = base.width + 0.04 * size;
        double widest = 0.0;
        if (hasBelow) {
            place(base, below, x, 0.22 * size);
            widest = std::max(widest, below.width);
        }
        if (hasAbove) {
            place(base, above, x, -0.42 * size);
            widest = std::max(widest, above.width);
        }
        base.width += widest > 0.0 ? widest + 0.08 * size : 0.0;
        return base;
    }

    /// Limits above and below a sum.
    static SetFormula stacked(const SetFormula& base, const SetFormula* below, const SetFormula* above, double size) {
        SetFormula whole;
        whole.width =
            std::max({base.width, below != nullptr ? below->width : 0.0, above != nullptr ? above->width : 0.0}) + 0.15 * size;
        const auto centre = [&](const SetFormula& part, double y) { place(whole, part, 0.5 * (whole.width - part.width), y); };
        centre(base, 0.0);
        if (below != nullptr) {
            centre(*below, base.descent + below->ascent + 0.1 * size);
        }
        if (above != nullptr) {
            centre(*above, -base.ascent - above->descent - 0.1 * size);
        }
        return whole;
    }

    SetFormula atom(double size) {
        if (atEnd()) {
            return {};
        }
        const QChar c = m_text[m_at++];
        if (c == u'\\') {
            return command(size);
        }
        if (c == u'{') {
            return row(size, u'}');
        }
        if (c == u' ') {
            return {};
        }
        if (QStringLiteral("=+<>").contains(c)) {
            return letters(QStringLiteral(" %1 ").arg(c), size, false, false);
        }
        if (c == u'-') {
            return letters(QStringLiteral(" − "), size, false, false);
        }
        return letters(QString(c), size, c.isLetter(), false);
    }

    SetFormula command(double size) {
        QString name;
        while (!atEnd() && peek().isLetter()) {
            name += m_text[m_at++];
        }
        if (name.isEmpty() && !atEnd()) {
            name = m_text[m_at++];
        }
        if (name == QLatin1String("frac")) {
            const SetFormula above = group(0.9 * size);
            const SetFormula below = group(0.9 * size);
            return fraction(above, below, size);
        }
        if (name == QLatin1String("sqrt")) {
            return root(size);
        }
        if (name == QLatin1String("sum") || name == QLatin1String("int")) {
            m_tall = true;
            SetFormula sign =
                letters(name == QLatin1String("sum") ? QStringLiteral("∑") : QStringLiteral("∫"), 1.5 * size, false, false);
            // About the axis of the line.
            SetFormula whole;
            whole.width = sign.width;
            place(whole, sign, 0.0, 0.22 * size);
            return whole;
        }
        if (name == QLatin1String("text") || name == QLatin1String("mathbf")) {
            return letters(plainGroup(), size, false, name == QLatin1String("mathbf"));
        }
        const QString sign = signs().value(name, name);
        const bool greek = sign.size() == 1 && sign[0].isLetter();
        return letters(sign, size, greek && sign[0].isLower(), false);
    }

    /// The text in braces as it stands.
    QString plainGroup() {
        const qsizetype open = m_text.indexOf(u'{', m_at);
        const qsizetype close = m_text.indexOf(u'}', open);
        if (open != m_at || close < 0) {
            return {};
        }
        m_at = close + 1;
        return m_text.mid(open + 1, close - open - 1);
    }

    static SetFormula fraction(const SetFormula& above, const SetFormula& below, double size) {
        SetFormula whole;
        const double line = 0.05 * size;
        const double axis = -0.28 * size;
        const double pad = 0.12 * size;
        whole.width = std::max(above.width, below.width) + 4.0 * pad;
        place(whole, above, 0.5 * (whole.width - above.width), axis - above.descent - pad);
        place(whole, below, 0.5 * (whole.width - below.width), axis + below.ascent + pad);
        whole.outline.addRect(pad, axis - 0.5 * line, whole.width - 2.0 * pad, line);
        return whole;
    }

    SetFormula root(double size) {
        SetFormula degree;
        if (!atEnd() && peek() == u'[') {
            ++m_at;
            degree = row(0.55 * size, u']');
        }
        const SetFormula inner = group(size);
        SetFormula whole;
        const double line = 0.05 * size;
        const double top = -inner.ascent - 0.14 * size;
        const double bottom = inner.descent;
        const double start = std::max(0.0, degree.width - 0.2 * size);
        const double hook = 0.45 * size;
        // The sign as a band of the thickness of the line.
        QPainterPath sign;
        const double middle = 0.5 * (top + bottom);
        sign.moveTo(start, middle);
        sign.lineTo(start + 0.16 * size, middle - 0.08 * size);
        sign.lineTo(start + 0.30 * size, bottom - 0.12 * size);
        sign.lineTo(start + hook, top);
        sign.lineTo(start + hook + inner.width + 0.1 * size, top);
        sign.lineTo(start + hook + inner.width + 0.1 * size, top + line);
        sign.lineTo(start + hook + 0.03 * size, top + line);
        sign.lineTo(start + 0.31 * size, bottom);
        sign.lineTo(start + 0.27 * size, bottom);
        sign.lineTo(start + 0.12 * size, middle);
        sign.closeSubpath();
        whole.outline.addPath(sign);
        whole.ascent = -top;
        whole.descent = bottom;
        place(whole, inner, start + hook + 0.05 * size, 0.0);
        if (degree.width > 0.0) {
            place(whole, degree, std::max(0.0, start - degree.width + 0.2 * size), middle - 0.16 * size);
        }
        whole.width = start + hook + inner.width + 0.15 * size;
        return whole;
    }

    QString m_text;
    qsizetype m_at = 0;
    bool m_tall = false;
};

}  // namespace

SetFormula setFormula(const QString& notation, double size) {
    return Typesetter(notation).run(size);
}

QByteArray formulaSvg(const QString& notation, double size, const QString& words) {
    const SetFormula set = setFormula(notation, size);
    QString path;
    const auto number = [](double value) { return QString::number(value, 'f', 2); };
    const QPainterPath outline = set.outline.translated(0.0, set.ascent);
    for (int i = 0; i < outline.elementCount(); ++i) {
        const QPainterPath::Element element = outline.elementAt(i);
        const char* letter = element.isMoveTo() ? "M" : element.isLineTo() ? "L" : element.isCurveTo() ? "C" : " ";
        path += QLatin1String(letter) + number(element.x) + QLatin1Char(' ') + number(element.y);
    }
    return QStringLiteral(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"%1\" width=\"%2\" height=\"%3\" "
               "viewBox=\"0 0 %2 %3\"><path fill=\"currentColor\" fill-rule=\"nonzero\" d=\"%4\"/></svg>")
        .arg(words.toHtmlEscaped(), number(set.width + 1.0), number(set.ascent + set.descent + 1.0), path)
        .toUtf8();
}

}  // namespace rubble::figures
