#include "widgets/basics/panel.h"

#include <QApplication>
#include <QCursor>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/basics/language.h"
#include "widgets/basics/parameter_editor.h"
#include "widgets/basics/prediction_box.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/unit_label.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/report/spoken_text.h"

namespace rubble::widgets {

namespace {

/// The layout of what a panel scrolls. A scroll area does not ask for the height that wrapped sentences need at its width, so this
/// does whenever things are placed: not every change of them is told to the widget as an event.
class PanelColumn : public QVBoxLayout {
public:
    PanelColumn(Panel& panel, QWidget* body) : QVBoxLayout(body), m_panel(panel) {}
    void setGeometry(const QRect& place) override {
        m_panel.keepInHand();
        QVBoxLayout::setGeometry(place);
        parentWidget()->setMinimumHeight(totalHeightForWidth(parentWidget()->width()));
    }

private:
    Panel& m_panel;
};

/// The layout of a group. When a sentence of it goes, the group is as high as before for a moment: its rows do not spread in that
/// room, unless one of them is there to grow.
class GroupColumn : public QVBoxLayout {
public:
    explicit GroupColumn(QWidget* group) : QVBoxLayout(group) {}
    void setGeometry(const QRect& place) override {
        const bool grows = (expandingDirections() & Qt::Vertical) != 0;
        const int needed = hasHeightForWidth() ? totalHeightForWidth(place.width()) : totalSizeHint().height();
        const int height = grows ? place.height() : std::min(place.height(), needed);
        QVBoxLayout::setGeometry({place.topLeft(), QSize(place.width(), height)});
    }
};

}  // namespace

Notice::Notice(QWidget* parent) : QFrame(parent), m_label(new QLabel) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 8, 10, 8);
    row->addWidget(m_label);
    m_label->setWordWrap(true);
    m_label->setTextFormat(Qt::RichText);
    m_label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::LinksAccessibleByMouse);
    hide();
}

void Notice::set(Kind kind, const QString& what, const QString& remedy) {
    static constexpr std::array names = {"note", "finding", "error"};
    setProperty("kind", QString::fromLatin1(names[static_cast<std::size_t>(kind)]));
    QString html = what.toHtmlEscaped().replace(u'\n', QStringLiteral("<br/>"));
    if (!remedy.isEmpty()) {
        html += QStringLiteral("<br/><span style='color:%1'>%2</span>").arg(tints().muted.name(), remedy.toHtmlEscaped());
    }
    m_label->setText(html);
    setVisible(!what.isEmpty());
    // A style sheet reads properties when a widget is polished.
    style()->unpolish(this);
    style()->polish(this);
}

QString Notice::text() const {
    return isHidden() ? QString() : m_label->text();
}

namespace {

/// Where something was found. Of a file its name: a path is longer than a panel is wide.
QString shownExample(const std::string& example) {
    const QFileInfo file(QString::fromStdString(example));
    return file.isAbsolute() && !file.fileName().isEmpty() ? file.fileName() : figures::spokenText(example);
}

/// A value beside the name of its setting. Times and lengths have their unit, in which a small one can be read.
QString valueOfSetting(const Parameter& row, const ParameterValue& value) {
    const auto* number = std::get_if<double>(&value);
    return number != nullptr && (row.unit == "s" || row.unit == "m") ? shownWith(*number, row.unit) : shownValue(value);
}

}  // namespace

RemedyButton::RemedyButton(const RemedySetting& setting, QWidget* parent) : QPushButton(parent), m_setting(setting) {
    const Parameter& row = *findParameter(setting.key).first;
    setObjectName(QStringLiteral("applyRemedy"));
    setText(tr("Set “%1” to %2").arg(said("parameters", row.label), valueOfSetting(row, setting.value)));
    connect(this, &QPushButton::clicked, this, [this] { emit chosen(QString::fromStdString(m_setting.key), m_setting.value); });
}

void RemedyButton::setScenario(const Scenario& scenario) {
    const bool isSet = parameterValue(scenario, m_setting.key) == m_setting.value;
    setEnabled(!isSet);
    const bool afterRun = findParameter(m_setting.key).first->stage == Stage::Simulation;
    setToolTip(!isSet     ? tr("Change this setting; Ctrl+Z takes it back")
               : afterRun ? tr("It is set: simulate to see what it does")
                          : tr("It is set"));
}

FindingList::FindingList(QWidget* parent) : QWidget(parent), m_column(new QVBoxLayout(this)) {
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(8);
    hide();
}

void FindingList::set(const Findings& findings, const RemedyGrounds& grounds, const std::vector<RemedySetting>& elsewhere) {
    std::vector<RemedySetting> offered = elsewhere;
    while (QLayoutItem* item = m_column->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const Finding& finding : findings.list()) {
        auto* notice = new Notice;
        QString text = worded(finding.what);
        // Some sentences name their count themselves.
        if (finding.count > 1 && !text.contains(shownCount(finding.count))) {
            text = tr("%1×: %2").arg(shownCount(finding.count), text);
        }
        if (!finding.example.empty()) {
            text += QStringLiteral(" (") + tr("first: %1").arg(shownExample(finding.example)) + QStringLiteral(")");
        }
        // Before it shows itself: without a parent it would be a window.
        m_column->addWidget(notice);
        notice->set(Notice::Kind::Finding, text, worded(finding.remedy));
        notice->setToolTip(QFileInfo(QString::fromStdString(finding.example)).isAbsolute() ? QString::fromStdString(finding.example)
                                                                                           : QString());
        addButtons(finding, grounds, offered);
    }
    m_count = static_cast<std::int64_t>(findings.list().size());
    setVisible(!findings.empty());
}

void FindingList::addButtons(const Finding& finding, const RemedyGrounds& grounds, std::vector<RemedySetting>& offered) {
    const auto setting = remedySettingOf(finding, grounds);
    // What a button does may set other findings, which ends the button.
    if (setting && std::find(offered.begin(), offered.end(), *setting) == offered.end()) {
        offered.push_back(*setting);
        auto* button = new RemedyButton(*setting);
        button->setScenario(m_scenario);
        connect(button, &RemedyButton::chosen, this, [this](const QString& key, const ParameterValue& value) {
            QTimer::singleShot(0, this, [this, key, value] { emit remedyChosen(key, value); });
        });
        m_column->addWidget(button, 0, Qt::AlignLeft);
    }
    for (const Doing& doing : m_doings) {
        const bool group = doing.id.ends_with('.') && finding.what.id.starts_with(doing.id);
        if (group || doing.id == finding.what.id) {
            auto* button = new QPushButton(doing.words);
            connect(button, &QPushButton::clicked, this, [this, act = doing.act] { QTimer::singleShot(0, this, act); });
            m_column->addWidget(button, 0, Qt::AlignLeft);
        }
    }
}

void FindingList::setScenario(const Scenario& scenario) {
    m_scenario = scenario;
    for (auto* button : findChildren<RemedyButton*>()) {
        button->setScenario(scenario);
    }
}

/// Those that a panel shows, or would if it were in front.
std::vector<FindingList*> findingLists(const QWidget& panel) {
    std::vector<FindingList*> shown;
    for (FindingList* list : panel.findChildren<FindingList*>()) {
        if (list->count() > 0 && list->isVisibleTo(&panel)) {
            shown.push_back(list);
        }
    }
    return shown;
}

PanelGroup::PanelGroup(const QString& heading, QWidget* parent) : QWidget(parent), m_grid(new QGridLayout) {
    auto* title = new QLabel(heading);
    auto* column = new GroupColumn(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    title->setObjectName(QStringLiteral("groupHeading"));
    title->setFont(groupFont());
    column->addWidget(title);
    title->setVisible(!heading.isEmpty());
    column->addLayout(m_grid);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(8);
    m_grid->setVerticalSpacing(4);
    m_grid->setColumnStretch(0, 5);
    m_grid->setColumnStretch(1, 4);
    m_grid->setColumnMinimumWidth(0, 80);
    m_grid->setColumnMinimumWidth(2, 28);
}

QLabel* PanelGroup::addValue(const QString& label, const QString& unit, const QString& tip) {
    const int row = m_grid->rowCount();
    auto* name = new QLabel(label);
    name->setWordWrap(true);
    name->setToolTip(tip);
    auto* value = new QLabel(QString(QChar(0x2013)));
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    // A long one takes further lines, never the room of the names.
    value->setWordWrap(true);
    value->setObjectName(QStringLiteral("value"));
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setToolTip(tip);
    value->setAccessibleName(label);
    auto* of = new UnitLabel(unit);
    m_grid->addWidget(name, row, 0);
    m_grid->addWidget(value, row, 1);
    m_grid->addWidget(of, row, 2);
    return value;
}

ParameterEditor* PanelGroup::addParameter(const Parameter& parameter, const std::string& subject) {
    const int row = m_grid->rowCount();
    auto* editor = new ParameterEditor(parameter, subject);
    auto* name = new QLabel(editor->label());
    name->setWordWrap(true);
    name->setToolTip(editor->toolTip());
    name->setBuddy(editor);
    auto* of = new UnitLabel(editor->siUnit());
    QObject::connect(editor, &ParameterEditor::unitShown, of, &UnitLabel::follow);
    m_grid->addWidget(name, row, 0);
    m_grid->addWidget(editor, row, 1);
    m_grid->addWidget(of, row, 2);
    return editor;
}

void PanelGroup::addField(const QString& label, QWidget* field, const QString& unit, const QString& tip) {
    const int row = m_grid->rowCount();
    auto* name = new QLabel(label);
    name->setWordWrap(true);
    name->setToolTip(tip);
    name->setBuddy(field);
    field->setToolTip(tip);
    auto* of = new UnitLabel(unit);
    m_grid->addWidget(name, row, 0);
    m_grid->addWidget(field, row, 1);
    m_grid->addWidget(of, row, 2);
}

void PanelGroup::addWide(QWidget* widget) {
    m_grid->addWidget(widget, m_grid->rowCount(), 0, 1, 3);
}

QLabel* PanelGroup::addNote(const QString& text) {
    auto* note = new QLabel(text);
    note->setObjectName(QStringLiteral("muted"));
    note->setWordWrap(true);
    addWide(note);
    return note;
}

void askIn(QWidget& field) {
    constexpr int around = 60;  // pixels, so that its label is seen as well
    for (QWidget* above = field.parentWidget(); above != nullptr; above = above->parentWidget()) {
        if (auto* area = qobject_cast<QScrollArea*>(above)) {
            area->ensureWidgetVisible(&field, around, around);
        }
    }
    field.setFocus(Qt::OtherFocusReason);
}

QVBoxLayout* pageColumn(QWidget& page, const QString& title) {
    page.setObjectName(QStringLiteral("panelBody"));
    page.setAttribute(Qt::WA_StyledBackground);
    auto* outer = new QVBoxLayout(&page);
    outer->setContentsMargins(0, 0, 0, 0);
    auto* body = new QWidget;
    body->setObjectName(QStringLiteral("panelBody"));
    auto* scroll = new QScrollArea;
    scroll->setWidget(body);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    outer->addWidget(scroll);
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(16, 12, 16, 12);
    column->setSpacing(8);
    auto* head = new QLabel(title);
    head->setFont(titleFont());
    column->addWidget(head);
    return column;
}

Panel::Panel(const QString& title, const QString& question, QWidget* parent)
    : QScrollArea(parent), m_column(new QVBoxLayout), m_error(new Notice), m_stale(new Notice) {
    auto* body = new QWidget;
    body->setObjectName(QStringLiteral("panelBody"));
    auto* outer = new PanelColumn(*this, body);
    outer->setContentsMargins(14, 12, 14, 16);
    outer->setSpacing(4);
    auto* heading = new QLabel(title);
    heading->setFont(titleFont());
    outer->addWidget(heading);
    auto* subtitle = new QLabel(question);
    subtitle->setObjectName(QStringLiteral("muted"));
    subtitle->setWordWrap(true);
    outer->addWidget(subtitle);
    m_column->setSpacing(16);
    m_column->setContentsMargins(0, 12, 0, 0);
    m_column->addWidget(m_error);
    outer->addLayout(m_column);
    outer->addStretch();
    setWidget(body);
    setWidgetResizable(true);
    m_stale->setParent(this);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

QSize Panel::sizeHint() const {
    return {264, 480};
}

PanelGroup* Panel::addGroup(const QString& heading) {
    auto* group = new PanelGroup(heading);
    m_column->addWidget(group);
    return group;
}

void Panel::addWide(QWidget* widget) {
    m_column->addWidget(widget);
    if (auto* findings = qobject_cast<FindingList*>(widget)) {
        m_findingLists.push_back(findings);
        connect(findings, &FindingList::remedyChosen, this, &Panel::edited);
    }
}

void Panel::setStale(bool stale, const QString& why) {
    m_stale->set(Notice::Kind::Note, stale ? why : QString());
    placeFoot();
}

void Panel::placeFoot() {
    constexpr int margin = 8;
    const int wide = width() - 2 * margin;
    const int high = m_stale->isHidden() ? 0 : std::max(m_stale->heightForWidth(wide), m_stale->minimumSizeHint().height());
    setViewportMargins(0, 0, 0, high > 0 ? high + 2 * margin : 0);
    m_stale->setGeometry(margin, height() - high - margin, wide, high);
}

void Panel::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    placeFoot();
}

QWidget* Panel::focused() const {
    QWidget* focus = QApplication::focusWidget();
    return focus != nullptr && widget()->isAncestorOf(focus) ? focus : nullptr;
}

QWidget* Panel::inHand() const {
    // What is dragged stays in hand wherever the cursor gets to.
    if (QApplication::mouseButtons() != Qt::NoButton) {
        return focused();
    }
    const QPoint cursor = viewport()->mapFromGlobal(QCursor::pos());
    if (isVisible() && viewport()->rect().contains(cursor)) {
        return widget()->childAt(widget()->mapFrom(viewport(), cursor));
    }
    return focused();
}

void Panel::keepInHand() {
    if (m_inHand != nullptr) {
        return;
    }
    m_inHand = inHand();
    if (m_inHand == nullptr) {
        return;
    }
    m_inHandAt = m_inHand->mapTo(viewport(), QPoint(0, 0)).y();
    m_scrolledAt = verticalScrollBar()->value();
    // Once what changes is laid out as a whole.
    QTimer::singleShot(0, this, [this] {
        // Half way through it, what is in hand lies elsewhere for a moment.
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        const bool still = QApplication::mouseButtons() == Qt::NoButton || focused() == m_inHand;
        if (still && m_inHand != nullptr && m_inHand->isVisible() && verticalScrollBar()->value() == m_scrolledAt) {
            const int moved = m_inHand->mapTo(viewport(), QPoint(0, 0)).y() - m_inHandAt;
            verticalScrollBar()->setValue(m_scrolledAt + moved);
        }
        m_inHand.clear();
    });
}

void Panel::setError(const QString& what, const QString& remedy) {
    m_error->set(Notice::Kind::Error, what, remedy);
}

void Panel::setScenario(const Scenario& scenario) {
    for (ParameterEditor* editor : std::as_const(m_editors)) {
        editor->setValue(parameterValue(scenario, editor->key().toStdString()));
    }
    for (FindingList* findings : m_findingLists) {
        findings->setScenario(scenario);
    }
}

void Panel::setEditable(bool editable) {
    for (ParameterEditor* editor : std::as_const(m_editors)) {
        editor->setAvailable(editable, tr("Open a result first"));
    }
}

void Panel::addPrediction() {
    m_prediction = new PredictionBox;
    addWide(m_prediction);
    connect(m_prediction, &PredictionBox::helpRequested, this, &Panel::predictionHelpRequested);
}

void Panel::setPrediction(const PredictionContent& content) {
    if (m_prediction != nullptr) {
        m_prediction->setContent(content);
    }
}

ParameterEditor* Panel::addParameter(PanelGroup* group, const std::string& key) {
    const auto [row, subject] = findParameter(key);
    ParameterEditor* editor = group->addParameter(*row, subject);
    takeEditor(editor);
    return editor;
}

void Panel::takeEditor(ParameterEditor* editor) {
    connect(editor, &ParameterEditor::edited, this, &Panel::edited);
    m_editors.insert(editor->key(), editor);
}

void Panel::addRemaining(Stage stage, const QString& heading, bool (*elsewhere)(std::string_view key)) {
    PanelGroup* group = nullptr;
    for (const Parameter& row : parameterTable()) {
        const QString key = QString::fromUtf8(row.key.data(), static_cast<qsizetype>(row.key.size()));
        const bool shown = m_editors.contains(key) || (elsewhere != nullptr && elsewhere(row.key));
        if (row.stage == stage && !row.keyed() && !shown) {
            if (group == nullptr) {
                group = addGroup(heading);
            }
            addParameter(group, std::string(row.key));
        }
    }
}

}  // namespace rubble::widgets
