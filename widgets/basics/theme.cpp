#include "widgets/basics/theme.h"

#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QPainter>
#include <QPalette>
#include <QPointer>
#include <QProxyStyle>
#include <QRegularExpression>
#include <QStyleOption>
#include <algorithm>
#include <array>
#include <utility>

#include "widgets/basics/icons.h"

namespace rubble::widgets {

namespace {

render::Theme& themeInForce() {
    static render::Theme theme = render::Theme::Light;
    return theme;
}

/// Fusion, with boxes to tick and number fields that can be seen in the dark: it outlines them darker than what they stand on. The
/// signs of docks are as the other ones.
class BoxStyle : public QProxyStyle {
public:
    BoxStyle() : QProxyStyle(QStringLiteral("Fusion")) {}
    QIcon standardIcon(StandardPixmap sign, const QStyleOption* option, const QWidget* widget) const override {
        const bool close = sign == SP_TitleBarCloseButton;
        if (qobject_cast<const QDockWidget*>(widget) != nullptr && (close || sign == SP_TitleBarNormalButton)) {
            return glyphIcon(close ? Glyph::Close : Glyph::Float);
        }
        return QProxyStyle::standardIcon(sign, option, widget);
    }
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        if (element == PE_IndicatorCheckBox || element == PE_IndicatorItemViewItemCheck) {
            painter->save();
            painter->setBrush(Qt::NoBrush);
            painter->setPen(option->state.testFlag(State_Enabled) ? option->palette.color(QPalette::Dark)
                                                                  : option->palette.color(QPalette::Mid));
            painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
            painter->restore();
        }
    }
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override {
        QProxyStyle::drawComplexControl(control, option, painter, widget);
        const auto* spin = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
        const bool faint = themeInForce() == render::Theme::Dark && !option->state.testFlag(State_HasFocus);
        if (control == CC_SpinBox && spin != nullptr && spin->frame && faint) {
            painter->save();
            painter->setRenderHint(QPainter::Antialiasing);
            painter->setBrush(Qt::NoBrush);
            painter->setPen(option->palette.color(QPalette::Mid));
            painter->drawRoundedRect(QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5), 2.0, 2.0);
            painter->restore();
        }
    }
};

QFont sized(double factor, QFont::Weight weight) {
    QFont font = QApplication::font();
    const double points = font.pointSizeF() > 0.0 ? font.pointSizeF() : 9.0;
    font.setPointSizeF(points * factor);
    font.setWeight(weight);
    return font;
}

QPalette paletteOf(const figures::Palette& c) {
    QPalette p;
    p.setColor(QPalette::Window, c.panel);
    p.setColor(QPalette::WindowText, c.text);
    p.setColor(QPalette::Base, c.field);
    p.setColor(QPalette::AlternateBase, c.window);
    p.setColor(QPalette::Text, c.text);
    p.setColor(QPalette::Button, c.panel);
    p.setColor(QPalette::ButtonText, c.text);
    p.setColor(QPalette::ToolTipBase, c.panel);
    p.setColor(QPalette::ToolTipText, c.text);
    p.setColor(QPalette::PlaceholderText, c.muted);
    p.setColor(QPalette::Highlight, c.accent);
    p.setColor(QPalette::HighlightedText, c.accentText);
    p.setColor(QPalette::Link, c.accent);
    p.setColor(QPalette::LinkVisited, c.accent);
    p.setColor(QPalette::Light, c.field);
    p.setColor(QPalette::Midlight, c.hairline);
    p.setColor(QPalette::Mid, c.hairline);
    p.setColor(QPalette::Dark, c.muted);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        QColor faint = c.muted;
        faint.setAlphaF(0.6F);
        p.setColor(QPalette::Disabled, role, faint);
    }
    return p;
}

/// The style sheet with %name% for the colours of the palette.
QString sheetOf(const figures::Palette& c) {
    QString sheet = QStringLiteral(R"(
QMenuBar, QToolBar, #transportBar, #statusLine { background: %panel%; }
QMenuBar { border-bottom: 1px solid %hairline%; }
QMenuBar::item { padding: 4px 8px; background: transparent; }
QMenuBar::item:selected { background: %accentTint%; }
QMenu { background: %panel%; border: 1px solid %hairline%; padding: 4px 0; }
QMenu::item { padding: 5px 24px 5px 20px; }
QMenu::icon { padding-left: 10px; }
QMenu::item:selected { background: %accentTint%; color: %text%; }
QMenu::item:disabled { color: %muted%; }
QComboBox QAbstractItemView::item:disabled { color: %muted%; }
QMenu::separator { height: 1px; background: %hairline%; margin: 4px 0; }
QToolBar { border: none; border-bottom: 1px solid %hairline%; padding: 4px 6px; spacing: 4px; }
QToolBar::separator { background: %hairline%; width: 1px; margin: 5px 4px; }
QToolButton, QPushButton { border: 1px solid %hairline%; border-radius: 4px; padding: 4px 8px; background: %field%; color: %text%; }
#transportBar QToolButton { padding: 4px 5px; }
QToolButton:hover, QPushButton:hover { border-color: %muted%; }
QToolButton:focus, QPushButton:focus { border-color: %accent%; }
QToolButton:checked { background: %accentTint%; border-color: %accent%; color: %accent%; }
QToolButton:disabled, QPushButton:disabled { color: %muted%; background: transparent; }
QToolButton:checked:disabled { border-color: %muted%; }
QPushButton#primary, QToolButton#primary { background: %accent%; border-color: %accent%; color: %accentText%; font-weight: 600; }
QPushButton#primary:disabled, QToolButton#primary:disabled { background: transparent; border-color: %hairline%; color: %muted%; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QToolButton#autoMark { padding: 1px 5px; border-radius: 8px; color: %muted%; background: transparent; }
QToolButton#autoMark:checked { color: %accent%; background: %accentTint%; border-color: %accentTint%; }
QToolButton#segment { border-radius: 0; padding: 1px 6px; font-size: %small%pt; margin-left: -1px; color: %muted%; }
QToolButton#segment[place="first"] { border-top-left-radius: 4px; border-bottom-left-radius: 4px; margin-left: 0; }
QToolButton#segment[place="last"] { border-top-right-radius: 4px; border-bottom-right-radius: 4px; }
QToolButton#segment:checked { color: %accent%; background: %accentTint%; border-color: %accent%; font-weight: 600; }
QToolButton#segment:focus { border-color: %text%; }
QToolButton#fold { border: none; background: transparent; padding: 0; }
QToolButton#fold:focus { border: 1px dotted %accent%; }
QLineEdit { border: 1px solid %hairline%; border-radius: 4px; padding: 3px 6px; background: %field%; color: %text%;
  selection-background-color: %accent%; selection-color: %accentText%; }
QLineEdit:focus { border-color: %accent%; }
QLineEdit:disabled, QPlainTextEdit:disabled { color: %muted%; background: transparent; border-style: dashed; }
QLineEdit[wrong="true"] { border-color: %error%; }
QComboBox QAbstractItemView { background: %field%; color: %text%; border: 1px solid %hairline%; selection-background-color: %accentTint%;
  selection-color: %text%; outline: none; }
#complaint { color: %error%; background: %panel%; }
#groupHeading, #muted, #unit { color: %muted%; }
#rail { background: %panel%; border-right: 1px solid %hairline%; }
#panelBody, QScrollArea { background: %panel%; }
#panelStack { background: %panel%; border-right: 1px solid %hairline%; }
#value { color: %text%; font-weight: 600; }
rubble--widgets--Notice { border: none; border-left: 3px solid %muted%; background: %window%; border-radius: 2px; }
rubble--widgets--Notice[kind="finding"] { border-left-color: %finding%; background: %findingTint%; }
rubble--widgets--Notice[kind="error"] { border-left-color: %error%; }
#noticeBar { background: %findingTint%; border-bottom: 1px solid %hairline%; }
#bottom { background: %panel%; border-top: 1px solid %hairline%; }
#hairline { background: %hairline%; border: none; }
#statusLine { border-top: 1px solid %hairline%; }
#emptyState { background: %window%; }
#tourCard { background: %panel%; border: 1px solid %hairline%; border-radius: 6px; }
QListView { background: %panel%; border: none; color: %text%; outline: none; }
QListView::item { padding: 3px 6px; border-radius: 3px; }
QListView::item:selected { background: %accentTint%; color: %text%; }
QPlainTextEdit { border: 1px solid %hairline%; border-radius: 4px; background: %field%; color: %text%;
  selection-background-color: %accent%; selection-color: %accentText%; }
QPlainTextEdit:focus { border-color: %accent%; }
QDockWidget { color: %text%; }
QDockWidget::title { background: %panel%; padding: 6px 10px; border-left: 1px solid %hairline%; border-bottom: 1px solid %hairline%; }
QMainWindow::separator { background: %hairline%; width: 1px; height: 1px; }
QTableView { background: %panel%; alternate-background-color: %panel%; border: none; gridline-color: %hairline%; color: %text%;
  selection-background-color: %accentTint%; selection-color: %text%; }
QHeaderView::section { font-size: %small%pt; background: %panel%; color: %muted%; border: none; border-bottom: 1px solid %hairline%; padding: 2px 4px; }
QTableView::item { border-bottom: 1px solid %hairline%; padding: 2px 4px; }
QScrollBar:vertical { background: transparent; width: 9px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 9px; margin: 0; }
QScrollBar::handle { background: %hairline%; border-radius: 4px; min-height: 24px; min-width: 24px; }
QScrollBar::handle:hover { background: %muted%; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QSlider { min-height: 20px; }
QSlider::groove:horizontal { height: 4px; border-radius: 2px; background: %hairline%; }
QSlider::sub-page:horizontal { border-radius: 2px; background: %accent%; }
QSlider::sub-page:horizontal:disabled { background: %hairline%; }
QSlider::handle:horizontal { width: 14px; margin: -6px 0; border: 1px solid %muted%; border-radius: 8px; background: %field%; }
QSlider::handle:horizontal:hover, QSlider::handle:horizontal:focus { border-color: %accent%; }
QSlider::handle:horizontal:disabled { border-color: %hairline%; background: %panel%; }
QToolTip { background: %panel%; color: %text%; border: 1px solid %hairline%; padding: 4px; }
QProgressBar { border: none; border-radius: 3px; background: %hairline%; max-height: 6px; min-height: 6px; }
QProgressBar::chunk { background: %accent%; border-radius: 3px; }
QTextBrowser { background: %panel%; border: none; color: %text%; }
)");
    const std::initializer_list<std::pair<const char*, QColor>> names = {{"panel", c.panel},
                                                                         {"window", c.window},
                                                                         {"field", c.field},
                                                                         {"hairline", c.hairline},
                                                                         {"text", c.text},
                                                                         {"muted", c.muted},
                                                                         {"accent", c.accent},
                                                                         {"accentText", c.accentText},
                                                                         {"accentTint", c.accentTint},
                                                                         {"findingTint", c.findingTint},
                                                                         {"finding", c.finding},
                                                                         {"error", c.error}};
    for (const auto& [name, colour] : names) {
        sheet.replace(QLatin1Char('%') + QLatin1String(name) + QLatin1Char('%'), colour.name());
    }
    return sheet.replace(QStringLiteral("%small%"), QString::number(headingFont().pointSizeF(), 'f', 1));
}

}  // namespace

namespace {

/// Texts that were set before name tints of then, and links got the colour of the palette when they were read.
void recolourTexts(const figures::Palette& before, const figures::Palette& now) {
    if (&before == &now) {
        return;
    }
    const std::array<std::pair<QString, QString>, 4> tints{{{before.muted.name(), now.muted.name()},
                                                            {before.text.name(), now.text.name()},
                                                            {before.accent.name(), now.accent.name()},
                                                            {before.finding.name(), now.finding.name()}}};
    static const QRegularExpression named(QStringLiteral("(?<=color:)#[0-9a-f]{6}"));
    for (QWidget* widget : QApplication::allWidgets()) {
        auto* label = qobject_cast<QLabel*>(widget);
        if (label == nullptr ||
            !(label->text().contains(QLatin1String("color:#")) || label->text().contains(QLatin1String("<a ")))) {
            continue;
        }
        QString text = label->text();
        for (auto found = named.globalMatch(label->text()); found.hasNext();) {
            const QRegularExpressionMatch match = found.next();
            const auto tint =
                std::find_if(tints.begin(), tints.end(), [&](const auto& each) { return each.first == match.captured(); });
            if (tint != tints.end()) {
                text.replace(match.capturedStart(), match.capturedLength(), tint->second);
            }
        }
        // The same text would not be read again.
        label->clear();
        label->setText(text);
    }
}

}  // namespace

render::Theme systemTheme() {
    static const render::Theme theme =
        QApplication::palette().color(QPalette::Window).lightness() < 110 ? render::Theme::Dark : render::Theme::Light;
    return theme;
}

render::Theme themeNamed(const QString& name) {
    return name == QLatin1String("dark")    ? render::Theme::Dark
           : name == QLatin1String("light") ? render::Theme::Light
                                            : systemTheme();
}

void giveColours(render::Theme theme) {
    systemTheme();
    static QPointer<QCoreApplication> coloured;
    const render::Theme wanted = theme == render::Theme::Dark ? render::Theme::Dark : render::Theme::Light;
    if (coloured == qApp && wanted == themeInForce()) {
        return;
    }
    coloured = qApp;
    themeInForce() = wanted;
    useIconTheme(wanted == render::Theme::Dark);
    QApplication::setStyle(new BoxStyle);
    QApplication::setPalette(paletteOf(tints()));
}

void applyTheme(render::Theme theme) {
    const figures::Palette& before = tints();
    giveColours(theme);
    recolourTexts(before, tints());
    const QString sheet = sheetOf(tints());
    if (qApp->styleSheet() != sheet) {
        qApp->setStyleSheet(sheet);
    }
}

void takeOffSheet() {
    if (!qApp->styleSheet().isEmpty()) {
        qApp->setStyleSheet(QString());
    }
}

render::Theme currentTheme() {
    return themeInForce();
}

const figures::Palette& tints() {
    return figures::palette(themeInForce());
}

QFont titleFont() {
    return sized(1.25, QFont::DemiBold);
}

QFont textFont() {
    return sized(1.0, QFont::Normal);
}

QFont headingFont() {
    return sized(0.86, QFont::Normal);
}

QFont groupFont() {
    QFont font = headingFont();
    font.setCapitalization(QFont::AllUppercase);
    return font;
}

QFont largeFigureFont() {
    return sized(1.9, QFont::Normal);
}

}  // namespace rubble::widgets
