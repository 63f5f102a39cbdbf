// The commands of PanelDesigner: actions with their keys, the tool bar and the menu of the canvas.
#include "editor/kit/edit_history.h"
#include "editor/kit/icons.h"
#include "hmi/designer/editors/theme_dialog.h"
#include "hmi/designer/panel_designer.h"
#include "hmi/model/property_literals.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QToolBar>

namespace plc::hmi {

QAction* PanelDesigner::add(const QString& name, const QString& title, kit::Icon icon, const QKeySequence& shortcut,
                            const std::function<void()>& run) {
    auto* action = new QAction(kit::icon(icon), title, this);
    action->setObjectName(name);
    if (!shortcut.isEmpty()) {
        action->setShortcut(shortcut);
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        action->setToolTip(QStringLiteral("%1 (%2)").arg(title, shortcut.toString(QKeySequence::NativeText)));
    }
    connect(action, &QAction::triggered, this, [run] { run(); });
    addAction(action);
    m_actions.insert(name, action);
    return action;
}

void PanelDesigner::addEdit(const QString& name, const QString& title, kit::Icon icon, const QKeySequence& shortcut,
                            const std::function<Edit()>& edit) {
    add(name, title, icon, shortcut, [this, title, edit] { m_document.perform(title, edit()); });
}

void PanelDesigner::makeActions() {
    using kit::Icon;
    const auto panel = [this]() -> const Panel& { return m_document.panel(); };
    const auto ids = [this]() -> const ElementIds& { return m_selection.ids(); };
    QAction* undo = kit::makeUndoAction(m_document.undoStack(), this);
    QAction* redo = kit::makeRedoAction(m_document.undoStack(), this);
    for (QAction* action : {undo, redo}) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        addAction(action);
    }
    m_actions.insert(QStringLiteral("undo"), undo);
    m_actions.insert(QStringLiteral("redo"), redo);
    add(QStringLiteral("cut"), tr("Cut"), Icon::Cut, QKeySequence::Cut, [this] { cut(); });
    add(QStringLiteral("copy"), tr("Copy"), Icon::Copy, QKeySequence::Copy, [this] { copy(); });
    add(QStringLiteral("paste"), tr("Paste"), Icon::Paste, QKeySequence::Paste, [this] { paste(); });
    add(QStringLiteral("paste-in-place"), tr("Paste in Place"), Icon::Paste,
        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_V), [this] { paste(true); });
    add(QStringLiteral("duplicate"), tr("Duplicate"), Icon::Copy, QKeySequence(Qt::CTRL | Qt::Key_D),
        [this] { duplicate(); });
    add(QStringLiteral("duplicate-array"), tr("Duplicate as Array…"), Icon::Table,
        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_D), [this] { duplicateAsArray(); });
    add(QStringLiteral("arrange-array"), tr("Arrange Over Array…"), Icon::Table, {}, [this] { arrangeOverArray(); });
    add(QStringLiteral("fix-all"), tr("Fix All Issues"), Icon::Build, {}, [this] { fixAll(); });
    add(QStringLiteral("select-all"), tr("Select All"), Icon::Select, QKeySequence::SelectAll, [this] { selectAll(); });
    addEdit(QStringLiteral("delete"), tr("Delete"), Icon::Delete, {}, [=] { return removeElements(panel(), ids()); });
    const std::tuple<const char*, QString, Icon, Alignment> alignments[] = {
        {"align-left", tr("Align Left"), Icon::AlignLeft, Alignment::Left},
        {"align-center", tr("Align Centres"), Icon::AlignCenter, Alignment::CenterX},
        {"align-right", tr("Align Right"), Icon::AlignRight, Alignment::Right},
        {"align-top", tr("Align Top"), Icon::AlignTop, Alignment::Top},
        {"align-middle", tr("Align Middles"), Icon::AlignMiddle, Alignment::CenterY},
        {"align-bottom", tr("Align Bottom"), Icon::AlignBottom, Alignment::Bottom}};
    for (const auto& [name, title, icon, alignment] : alignments)
        addEdit(QString::fromLatin1(name), title, icon, {},
                [=, how = alignment] { return align(panel(), ids(), how); });
    addEdit(QStringLiteral("distribute-x"), tr("Distribute Horizontally"), Icon::DistributeX, {},
            [=] { return distribute(panel(), ids(), Direction::Horizontal); });
    addEdit(QStringLiteral("distribute-y"), tr("Distribute Vertically"), Icon::DistributeY, {},
            [=] { return distribute(panel(), ids(), Direction::Vertical); });
    addEdit(QStringLiteral("same-width"), tr("Same Width"), Icon::ZoomX, {},
            [=] { return makeSameSize(panel(), ids(), SameSize::Width); });
    addEdit(QStringLiteral("same-height"), tr("Same Height"), Icon::ZoomY, {},
            [=] { return makeSameSize(panel(), ids(), SameSize::Height); });
    addEdit(QStringLiteral("same-size"), tr("Same Size"), Icon::Fit, {},
            [=] { return makeSameSize(panel(), ids(), SameSize::Both); });
    addEdit(QStringLiteral("front"), tr("Bring to Front"), Icon::BringFront,
            QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_BracketRight),
            [=] { return reorder(panel(), ids(), Order::Front); });
    addEdit(QStringLiteral("forward"), tr("Bring Forward"), Icon::Up, QKeySequence(Qt::CTRL | Qt::Key_BracketRight),
            [=] { return reorder(panel(), ids(), Order::Forward); });
    addEdit(QStringLiteral("backward"), tr("Send Backward"), Icon::Down, QKeySequence(Qt::CTRL | Qt::Key_BracketLeft),
            [=] { return reorder(panel(), ids(), Order::Backward); });
    addEdit(QStringLiteral("back"), tr("Send to Back"), Icon::SendBack,
            QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_BracketLeft),
            [=] { return reorder(panel(), ids(), Order::Back); });
    add(QStringLiteral("group"), tr("Group"), Icon::Group, QKeySequence(Qt::CTRL | Qt::Key_G), [this] { group(); });
    add(QStringLiteral("ungroup"), tr("Ungroup"), Icon::Ungroup, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_G),
        [this] { ungroup(); });
    add(QStringLiteral("lay-row"), tr("Lay Out in a Row"), Icon::AlignMiddle, {}, [this] { layOut("row"); });
    add(QStringLiteral("lay-column"), tr("Lay Out in a Column"), Icon::AlignCenter, {}, [this] { layOut("column"); });
    add(QStringLiteral("lay-grid"), tr("Lay Out in a Grid"), Icon::Grid, {}, [this] { layOut("grid"); });
    addEdit(QStringLiteral("lock"), tr("Lock"), Icon::Lock, QKeySequence(Qt::CTRL | Qt::Key_L), [=] {
        bool all = true;
        for (const ElementId& id : ids()) all &= panel().find(id)->isSet("locked"_flag);
        return setLocked(panel(), ids(), !all);
    });
    QAction* grid =
        add(QStringLiteral("grid"), tr("Show the Grid"), Icon::Grid, QKeySequence(Qt::CTRL | Qt::Key_Apostrophe),
            [this] { m_canvas->setGridShown(m_actions[QStringLiteral("grid")]->isChecked()); });
    QAction* snap = add(QStringLiteral("snap"), tr("Snap (Alt: not now)"), Icon::Magnet, {},
                        [this] { m_canvas->setSnapping(m_actions[QStringLiteral("snap")]->isChecked()); });
    QAction* live = add(QStringLiteral("live"), tr("Live Preview"), Icon::Live, QKeySequence(Qt::Key_F6),
                        [this] { setLive(m_actions[QStringLiteral("live")]->isChecked()); });
    for (QAction* action : {grid, snap, live}) action->setCheckable(true);
    grid->setChecked(true);
    snap->setChecked(true);
    add(QStringLiteral("themes"), tr("Edit Themes…"), Icon::Theme, {},
        [this] { ThemeDialog(m_context, m_name, {}, this).exec(); });
    add(QStringLiteral("zoom-in"), tr("Zoom in"), Icon::ZoomIn, QKeySequence::ZoomIn,
        [this] { m_canvas->setZoom(m_canvas->zoom() * 1.25); });
    add(QStringLiteral("zoom-out"), tr("Zoom Out"), Icon::ZoomOut, QKeySequence::ZoomOut,
        [this] { m_canvas->setZoom(m_canvas->zoom() / 1.25); });
    add(QStringLiteral("zoom-1"), tr("Zoom 100 %"), Icon::Find, QKeySequence(Qt::CTRL | Qt::Key_0),
        [this] { m_canvas->setZoom(1); });
    add(QStringLiteral("zoom-fit"), tr("Zoom to Fit"), Icon::Fit, QKeySequence(Qt::CTRL | Qt::Key_9),
        [this] { m_canvas->zoomToFit(); });
}

QToolBar* PanelDesigner::makeToolBar() {
    auto* bar = new QToolBar;
    bar->setIconSize(QSize(16, 16));
    const auto put = [&](std::initializer_list<const char*> names) {
        for (const char* name : names) bar->addAction(m_actions.value(QString::fromLatin1(name)));
        bar->addSeparator();
    };
    put({"undo", "redo"});
    // Fields before buttons: what has no room goes into a menu at the end, which has buttons only.
    auto* languages = new QComboBox;
    languages->setToolTip(tr("Language shown"));
    languages->setAccessibleName(languages->toolTip());
    const auto fill = [this, languages] {
        const QSignalBlocker quiet(languages);
        languages->clear();
        for (const QString& tag : m_context.project().texts.settings().languages + QStringList{kPseudoTag})
            languages->addItem(QStringLiteral("%1 (%2)").arg(nativeName(tag), tag), tag);
        languages->setCurrentIndex(languages->findData(m_context.language()));
    };
    fill();
    connect(languages, &QComboBox::activated, this,
            [this, languages] { m_context.setLanguage(languages->currentData().toString()); });
    connect(&m_context, &DesignContext::languageChanged, languages, fill);
    connect(&m_context, &DesignContext::textsChanged, languages, fill); // a column may have come or gone
    bar->addWidget(languages);
    auto* themes = new QComboBox;
    themes->setToolTip(tr("Theme of the panel"));
    themes->setAccessibleName(themes->toolTip());
    const auto showTheme = [this, themes] {
        themes->setCurrentIndex(themes->findData(m_document.panel().text("theme"_text)));
    };
    const auto listThemes = [this, themes, showTheme] {
        themes->clear();
        for (const auto& [name, title] : {std::pair{"light", tr("Light")}, std::pair{"dark", tr("Dark")},
                                          std::pair{"contrast", tr("High contrast")}})
            themes->addItem(title, QString::fromLatin1(name));
        for (const auto& [name, theme] : m_context.project().themes.own()) themes->addItem(name, name);
        showTheme();
    };
    listThemes();
    connect(&m_context, &DesignContext::themesTaken, themes, listThemes);
    connect(themes, &QComboBox::activated, this, [this, themes] {
        m_document.perform(tr("Theme"),
                           hmi::setProperty(m_document.panel(), {}, "theme", toUtf8(themes->currentData().toString())));
    });
    connect(&m_document, &PanelDocument::changed, themes, showTheme);
    bar->addWidget(themes);
    bar->addAction(m_actions.value(QStringLiteral("themes")));
    bar->addSeparator();
    put({"align-left", "align-center", "align-right", "align-top", "align-middle", "align-bottom"});
    put({"distribute-x", "distribute-y", "same-size"});
    put({"front", "back", "group", "ungroup", "lock", "duplicate-array", "arrange-array"});
    put({"grid", "snap", "zoom-out", "zoom-in", "zoom-fit"});
    bar->addAction(m_actions.value(QStringLiteral("live")));
    auto* spacer = new QWidget;
    spacer->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(spacer);
    auto* zoom = new QLabel;
    const auto showZoom = [this, zoom] {
        zoom->setText(QStringLiteral("%1 %").arg(std::lround(m_canvas->zoom() * 100)));
    };
    connect(m_canvas, &DesignCanvas::zoomChanged, zoom, showZoom);
    showZoom();
    m_where->setMinimumWidth(80);
    bar->addWidget(m_where);
    bar->addWidget(zoom);
    return bar;
}

void PanelDesigner::updateActions() {
    const size_t count = m_selection.ids().size();
    for (const char* name :
         {"cut",          "copy",        "duplicate", "duplicate-array", "delete",       "align-left",
          "align-center", "align-right", "align-top", "align-middle",    "align-bottom", "front",
          "forward",      "backward",    "back",      "group",           "ungroup",      "lock",
          "lay-row",      "lay-column",  "lay-grid"})
        m_actions.value(QString::fromLatin1(name))->setEnabled(count > 0);
    m_actions.value(QStringLiteral("arrange-array"))->setEnabled(selectedFaceplate());
    for (const char* name : {"same-width", "same-height", "same-size"})
        m_actions.value(QString::fromLatin1(name))->setEnabled(count > 1);
    for (const char* name : {"distribute-x", "distribute-y"})
        m_actions.value(QString::fromLatin1(name))->setEnabled(count > 2);
}

void PanelDesigner::showMenu(QPoint at) {
    QMenu menu;
    for (const char* name : {"cut",
                             "copy",
                             "paste",
                             "paste-in-place",
                             "duplicate",
                             "duplicate-array",
                             "arrange-array",
                             "delete",
                             "",
                             "group",
                             "ungroup",
                             "lay-row",
                             "lay-column",
                             "lay-grid",
                             "lock",
                             "",
                             "front",
                             "forward",
                             "backward",
                             "back",
                             "",
                             "same-width",
                             "same-height",
                             "same-size",
                             "",
                             "fix-all"}) {
        if (*name)
            menu.addAction(m_actions.value(QString::fromLatin1(name)));
        else
            menu.addSeparator();
    }
    menu.exec(at);
}

} // namespace plc::hmi
