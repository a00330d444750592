#include "app/gui/help/help.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QDialog>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <array>
#include <utility>

#include "app/gui/help/manual.h"
#include "widgets/basics/language.h"
#include "widgets/basics/parameter_editor.h"

namespace rubble {

namespace {

/// Parts of the window and what of the manual is about them; the innermost part that a widget stands in decides.
constexpr std::array<std::pair<const char*, const char*>, 27> topics{{
    {"rubble::widgets::EffectRow", "Effects"},
    {"rubble::widgets::ContactTable", "Effects#Materials"},
    {"rubble::widgets::MaterialsTable", "Effects#Materials"},
    {"rubble::widgets::HealthList", "Health"},
    {"rubble::widgets::PredictionBox", "Measures#What accuracy costs"},
    {"rubble::widgets::RegroupForm", "Case"},
    {"rubble::widgets::CalibrationView", "Basic Grid#This machine"},
    {"rubble::widgets::ErrorBar", "Views and timeline"},
    {"rubble::widgets::AccuracyPage", "Measures#The measures"},
    {"rubble::widgets::AccuracyPanel", "Accuracy"},
    {"rubble::widgets::EnsemblePanel", "Ensembles and causes#In the window"},
    {"rubble::widgets::EnsemblePage", "Ensembles and causes#In the window"},
    {"rubble::widgets::CausesPanel", "Ensembles and causes#In the window"},
    {"rubble::widgets::CausesPage", "Ensembles and causes#In the window"},
    {"rubble::widgets::EvidencePanel", "Photographs"},
    {"rubble::widgets::EvidencePage", "Photographs"},
    {"rubble::widgets::RunMapPanel", "Debris maps#In the window"},
    {"rubble::widgets::ReportPanel", "Report"},
    {"rubble::widgets::CasePanel", "Case"},
    {"rubble::widgets::FragmentsPanel", "Fragments"},
    {"rubble::widgets::GridPanel", "Basic Grid"},
    {"rubble::widgets::EffectsPanel", "Effects"},
    {"rubble::widgets::RunPanel", "Run"},
    {"rubble::widgets::Timeline", "Views and timeline"},
    {"rubble::widgets::Transport", "Views and timeline"},
    {"rubble::widgets::ViewWidget", "Views and timeline"},
    {"rubble::widgets::StatusLine", "Figures in the panels#Status line"},
}};

HelpTopic topicFrom(const QString& place) {
    return {place.section(u'#', 0, 0), place.section(u'#', 1), {}};
}

/// The words of the sources that a text on screen says.
QString sourceOf(const QString& said) {
    for (const widgets::SourceText& text : widgets::Catalogue::spoken()) {
        const QString source = QString::fromUtf8(text.text);
        const QString words = QCoreApplication::translate(text.context.constData(), text.text.constData());
        if (words == said) {
            return source;
        }
        // A name with a value in it: the manual has what stands before the value.
        const qsizetype place = words.indexOf(QStringLiteral("%1"));
        if (place >= 0 && words.size() > 4 && source.indexOf(u'%') > 3) {
            const QString rest = words.mid(place + 2);
            bool number = false;
            if (said.startsWith(words.left(place)) && said.endsWith(rest) && said.size() > place + rest.size()) {
                QLocale().toDouble(said.mid(place, said.size() - place - rest.size()), &number);
            }
            if (number) {
                return source.left(source.indexOf(u'%')).trimmed();
            }
        }
    }
    return said;
}

bool isFigure(const QWidget& widget) {
    return widget.objectName() == QLatin1String("value") && qobject_cast<const QLabel*>(&widget) != nullptr;
}

}  // namespace

HelpTopic helpAbout(const QWidget* widget) {
    if (widget != nullptr && isFigure(*widget) && !widget->accessibleName().isEmpty()) {
        return {QStringLiteral("Figures in the panels"), {}, sourceOf(widget->accessibleName())};
    }
    for (const QWidget* at = widget; at != nullptr; at = at->parentWidget()) {
        if (const auto* editor = qobject_cast<const widgets::ParameterEditor*>(at)) {
            const std::string_view key = editor->row().key;
            return {QStringLiteral("Parameters"), {}, QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size()))};
        }
        if (const QString place = at->property("help").toString(); !place.isEmpty()) {
            return topicFrom(place);
        }
        for (const auto& [type, place] : topics) {
            if (at->inherits(type)) {
                return topicFrom(QLatin1String(place));
            }
        }
    }
    return {QStringLiteral("Start"), {}, {}};
}

Help::Help(QWidget& window) : m_window(window) {
    qApp->installEventFilter(this);
}

ManualWindow& Help::manual() {
    if (m_manual == nullptr) {
        m_manual = new ManualWindow(&m_window);
    }
    QWidget* modal = QApplication::activeModalWidget();
    lendManual(modal != nullptr && modal != m_manual ? modal : &m_window);
    m_manual->show();
    m_manual->raise();
    m_manual->activateWindow();
    return *m_manual;
}

void Help::lendManual(QWidget* to) {
    if (m_manual->parentWidget() == to) {
        return;
    }
    const bool shown = m_manual->isVisible();
    m_manual->setParent(to, m_manual->windowFlags());
    m_manual->setVisible(shown);
    if (auto* dialog = qobject_cast<QDialog*>(to)) {
        connect(
            dialog, &QDialog::finished, this,
            [this] {
                if (m_manual != nullptr) {
                    lendManual(&m_window);
                }
            },
            Qt::SingleShotConnection);
    }
}

QString Help::openPage() const {
    return m_manual != nullptr && m_manual->isVisible() ? m_manual->page() : QString();
}

void Help::showAbout(const QWidget* widget) {
    const HelpTopic topic = helpAbout(widget);
    manual().showPlace(topic.page, topic.heading, topic.words);
}

void Help::search() {
    manual().beginSearch();
}

bool Help::eventFilter(QObject* watched, QEvent* event) {
    auto* widget = qobject_cast<QWidget*>(watched);
    // The action's key holds for the window only: its dialogs are asked here.
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_F1 && widget != nullptr &&
        widget->window() != &m_window && widget->window()->parentWidget() == &m_window) {
        showAbout(widget);
        return true;
    }
    if (event->type() != QEvent::ContextMenu || widget == nullptr || widget->window() != &m_window || !isFigure(*widget)) {
        return QObject::eventFilter(watched, event);
    }
    auto* label = static_cast<QLabel*>(widget);
    auto* menu = new QMenu(label);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    connect(menu->addAction(tr("What is this number?")), &QAction::triggered, this, [this, label] { showAbout(label); });
    connect(menu->addAction(tr("Copy")), &QAction::triggered, label,
            [label] { QApplication::clipboard()->setText(label->text()); });
    menu->popup(static_cast<QContextMenuEvent*>(event)->globalPos());
    return true;
}

}  // namespace rubble
