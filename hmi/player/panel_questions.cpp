// What can be asked of an element of a panel that plays: why its values are as they are.
#include "hmi/player/panel_player.h"

#include "hmi/model/walk.h"
#include "hmi/player/panel_why.h"
#include "hmi/texts/system_texts.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QMetaMethod>

namespace plc::hmi {

namespace {

/// The expressions that an element shows or writes, each once, in the order of its properties.
QStringList expressionsOf(const Element& element) {
    QStringList all;
    forEachBinding(element, [&](const Found& found) {
        const QString text = found.text.trimmed();
        if (!text.isEmpty() && !all.contains(text)) all << text;
    });
    return all;
}

} // namespace

void PanelPlayer::contextMenuEvent(QContextMenuEvent* event) {
    const QPoint at = m_view->mapFromGlobal(event->globalPos());
    const ElementView* element = scene().viewAt(m_view->toPanel(at), true);
    const QStringList expressions = element ? expressionsOf(element->element()) : QStringList();
    if (expressions.isEmpty()) return QWidget::contextMenuEvent(event);
    QMenu menu(this);
    for (const QString& each : expressions) {
        QMenu* asked = expressions.size() == 1 ? &menu : menu.addMenu(each);
        if (asked == &menu) menu.addSection(each);
        kit::addWhyActions(
            *asked, [this, each](kit::AskWhy question) { askWhy(question, each); }, nullptr, language());
    }
    menu.exec(event->globalPos());
}

void PanelPlayer::askWhy(kit::AskWhy question, const QString& expression) {
    if (isSignalConnected(QMetaMethod::fromSignal(&PanelPlayer::whyRequested)))
        return emit whyRequested(question, expression); // the studio answers in its own view
    closeAnswer();
    const session::Run* run = m_station.shownRun();
    if (!run || run->history().statistics().scans == 0)
        return m_station.refuse(m_station.say(SystemText::NoController));
    const auto program = run->program();
    OperatorNames names = program ? operatorNames(m_project, *program, language()) : OperatorNames();
    m_why = new PanelWhy(run->history(), question, expression, values() ? values()->position() : std::nullopt,
                         language(), std::move(names), this);
    m_why->setGeometry(rect().adjusted(width() / 12, height() / 12, -width() / 12, -height() / 12));
    static_cast<QWidget*>(m_why.data())->show();
    m_why->setFocus();
}

PanelWhy* PanelPlayer::answer() const { return m_why; }

void PanelPlayer::closeAnswer() { delete m_why.data(); }

} // namespace plc::hmi
