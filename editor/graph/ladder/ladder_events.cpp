// Keys and the menu of ladder and function block diagrams.
#include "editor/graph/ladder/ladder_view.h"
#include "editor/kit/icons.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMessageBox>
#include <QMouseEvent>

namespace plc::editor {

using ladder::Node;
using ladder::NodeKind;

namespace {

struct KeyRow {
    int key;
    Qt::KeyboardModifiers modifiers;
    void (LadderView::*run)();
    const char* what;
};
/// CODESYS's keys where it has them. The cheat sheet shows this list.
constexpr KeyRow kKeys[] = {
    {Qt::Key_K, Qt::ControlModifier, &LadderView::insertContactLeft,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "Contact on the left; at a coil, the last contact")},
    {Qt::Key_D, Qt::ControlModifier, &LadderView::insertContactRight,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "Contact on the right")},
    {Qt::Key_R, Qt::ControlModifier, &LadderView::insertParallel,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "Parallel contact")},
    {Qt::Key_A, Qt::ControlModifier, &LadderView::insertCoil, QT_TRANSLATE_NOOP("plc::editor::LadderView", "Coil")},
    {Qt::Key_B, Qt::ControlModifier, &LadderView::insertBlock,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "Function block in the rung")},
    {Qt::Key_I, Qt::ControlModifier, &LadderView::insertRungAbove,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "Rung above")},
    {Qt::Key_T, Qt::ControlModifier, &LadderView::insertRungBelow,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "Rung below")},
    {Qt::Key_N, Qt::ControlModifier, &LadderView::negate,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "Negate a contact, a coil or a pin")},
    {Qt::Key_M, Qt::ControlModifier, &LadderView::nextCoil,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "Coil: normal, set, reset")},
    {Qt::Key_O, Qt::ControlModifier, &LadderView::editComment,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "Comment of the rung")},
    {Qt::Key_F2, Qt::NoModifier, &LadderView::editSelected,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "Edit what is selected (or Enter)")},
    {Qt::Key_Return, Qt::NoModifier, &LadderView::editSelected, nullptr},
    {Qt::Key_Insert, Qt::NoModifier, &LadderView::insertContactLeft, nullptr},
    {Qt::Key_Delete, Qt::NoModifier, &LadderView::deleteSelected,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "Delete what is selected")},
    {Qt::Key_F2, Qt::ShiftModifier, &LadderView::renameSelected,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "Rename the variable everywhere")},
    {Qt::Key_F12, Qt::NoModifier, &LadderView::definitionOfSelected,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "Go to the definition")},
    {Qt::Key_F12, Qt::ShiftModifier, &LadderView::usesOfSelected,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "References to the variable")},
    {Qt::Key_Return, Qt::AltModifier, &LadderView::fixSelected,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "Quick fix")},
    {Qt::Key_F2, Qt::ControlModifier, &LadderView::toggleBookmark,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "Bookmark on the rung")},
    {Qt::Key_F9, Qt::NoModifier, &LadderView::toggleBreakpoint,
     QT_TRANSLATE_NOOP("plc::editor::LadderView", "Breakpoint on the rung")},
    {Qt::Key_F1, Qt::NoModifier, &LadderView::showKeys, QT_TRANSLATE_NOOP("plc::editor::LadderView", "This list")},
};

const KeyRow* keyRow(const QKeyEvent& event) {
    const Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeypadModifier;
    for (const KeyRow& row : kKeys)
        if (row.key == event.key() && row.modifiers == modifiers) return &row;
    return nullptr;
}

bool isArrow(int key) {
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

} // namespace

void LadderView::showKeys() {
    QString rows;
    const auto add = [&](const QString& keys, const QString& what) {
        rows += "<tr><td style='padding-right:16px'><b>" + keys.toHtmlEscaped() + "</b></td><td>" +
                what.toHtmlEscaped() + "</td></tr>";
    };
    for (const KeyRow& row : kKeys)
        if (row.what)
            add(QKeySequence(static_cast<int>(row.modifiers) | row.key).toString(QKeySequence::NativeText),
                tr(row.what));
    add(tr("Arrows"), tr("Select the next part; Up and Down also the next rung"));
    add(QKeySequence(Qt::CTRL | Qt::Key_Up).toString(QKeySequence::NativeText),
        tr("Move the rung up; with Down, down"));
    add(QKeySequence(Qt::CTRL | Qt::Key_Left).toString(QKeySequence::NativeText),
        tr("Move the contact left; with Right, right"));
    add("/", tr("Typed before a name: a negated contact"));
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("Keys in Ladder and Function Block Diagrams"),
                                "<table cellspacing='0'>" + rows + "</table>", QMessageBox::Close, this);
    box->setObjectName("ladderKeys");
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void LadderView::keyPressEvent(QKeyEvent* event) {
    event->accept();
    if (const KeyRow* row = keyRow(*event)) return (this->*row->run)();
    const bool control = event->modifiers() & Qt::ControlModifier;
    switch (event->key()) {
    case Qt::Key_Enter:
        return editSelected();
    case Qt::Key_Left:
        return control ? moveContact(-1) : selectTowards(-1, 0);
    case Qt::Key_Right:
        return control ? moveContact(1) : selectTowards(1, 0);
    case Qt::Key_Up:
        return control ? moveRung(-1) : selectTowards(0, -1);
    case Qt::Key_Down:
        return control ? moveRung(1) : selectTowards(0, 1);
    case Qt::Key_Escape:
        m_isDragging = false;
        m_scene->markGap(std::nullopt);
        return m_scene->select({});
    default:
        event->ignore();
    }
}

bool LadderView::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_canvas && event->type() == QEvent::ShortcutOverride) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (keyRow(*key) || isArrow(key->key())) return event->accept(), true;
    }
    if (watched == m_canvas && event->type() == QEvent::KeyPress) {
        auto* key = static_cast<QKeyEvent*>(event);
        keyPressEvent(key);
        if (key->isAccepted()) return true;
    }
    if (watched == m_canvas->viewport() && mouseEvent(event)) return true;
    return GraphView::eventFilter(watched, event);
}

void LadderView::contextMenuEvent(QContextMenuEvent* event) {
    const bool isByKey = event->reason() == QContextMenuEvent::Keyboard; // then it is about what is selected
    const QPointF clicked = m_canvas->mapToScene(m_canvas->viewport()->mapFromGlobal(event->globalPos()));
    const LadderPick under = isByKey ? m_scene->picked() : m_scene->pickAt(clicked);
    if (under.rung.isValid()) m_scene->select(under);
    const Node* node = pickedNode();
    QMenu menu(this);
    const auto add = [&](kit::Icon icon, const QString& text, auto run) {
        connect(menu.addAction(kit::icon(icon), text), &QAction::triggered, this, run);
    };
    const auto gap = m_isStale || isByKey ? std::nullopt : m_scene->gapAt(clicked);
    if (gap) addWireMenu(menu, *gap);
    if (!m_isStale) {
        add(kit::Icon::Add, tr("Insert a Rung Above"), &LadderView::insertRungAbove);
        add(kit::Icon::Add, tr("Insert a Rung Below"), &LadderView::insertRungBelow);
        add(kit::Icon::AlignLeft, tr("Insert a Contact"), &LadderView::insertContactLeft);
        add(kit::Icon::Split, tr("Insert a Parallel Contact"), &LadderView::insertParallel);
        add(kit::Icon::Action, tr("Insert a Coil"), &LadderView::insertCoil);
        add(kit::Icon::Layers, tr("Insert a Function Block…"), &LadderView::insertBlock);
        menu.addSeparator();
        add(kit::Icon::Edit, tr("Edit"), &LadderView::editSelected);
        add(kit::Icon::Edit, tr("Comment…"), &LadderView::editComment);
        if (node) add(kit::Icon::Edit, tr("Negate"), &LadderView::negate);
        if (node && node->kind == NodeKind::Coil) add(kit::Icon::Edit, tr("Set or Reset"), &LadderView::nextCoil);
        add(kit::Icon::Up, tr("Move the Rung Up"), [this] { moveRung(-1); });
        add(kit::Icon::Down, tr("Move the Rung Down"), [this] { moveRung(1); });
        add(kit::Icon::Delete, tr("Delete"), &LadderView::deleteSelected);
        menu.addSeparator();
    }
    if (node && !m_isStale) {
        add(kit::Icon::Rename, tr("Rename…"), &LadderView::renameSelected);
        add(kit::Icon::Find, tr("Find References"), &LadderView::usesOfSelected);
        add(kit::Icon::Forward, tr("Go to Definition"), &LadderView::definitionOfSelected);
        if (!m_scene->problemAt(m_scene->picked()).isEmpty())
            add(kit::Icon::Lightbulb, tr("Quick Fix"), &LadderView::fixSelected);
        menu.addSeparator();
    }
    if (node && node->operand) {
        add(kit::Icon::Write, tr("Write TRUE"), [this] { writeSelected("TRUE"); });
        add(kit::Icon::Write, tr("Write FALSE"), [this] { writeSelected("FALSE"); });
        add(kit::Icon::Force, tr("Force TRUE"), [this] { forceSelected("TRUE"); });
        add(kit::Icon::Force, tr("Force FALSE"), [this] { forceSelected("FALSE"); });
        add(kit::Icon::Unforce, tr("Release"), [this] { forceSelected({}); });
    }
    add(kit::Icon::Breakpoint, tr("Toggle Breakpoint"), &LadderView::toggleBreakpoint);
    add(kit::Icon::Marker, tr("Toggle Bookmark"), &LadderView::toggleBookmark);
    menu.exec(isByKey && under.rung.isValid() ? m_canvas->menuPlace(m_scene->rectOf(under)) : event->globalPos());
}

} // namespace plc::editor
