#include "hmi/designer/panel_designer.h"

#include "editor/kit/edit_history.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/own_keys.h"
#include "editor/kit/theme.h"
#include "hmi/check/faceplate_check.h"
#include "hmi/check/standard_check.h"
#include "hmi/designer/array_arrangement_dialog.h"
#include "hmi/designer/array_dialog.h"
#include "hmi/designer/canvas/outline.h"
#include "hmi/designer/canvas/palette.h"
#include "hmi/model/property_literals.h"
#include "hmi/model/walk.h"
#include "hmi/player/panel_player.h"
#include "runtime/base/read_json.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QToolBar>
#include <QToolTip>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace plc::hmi {

namespace {
Panel panelNamed(DesignContext& context, const QString& name) {
    const NamedPanel* panel = context.project().find(name);
    return panel ? panel->panel : Panel();
}
} // namespace

PanelDesigner::PanelDesigner(DesignContext& context, const QString& panelName, QWidget* parent)
    : QWidget(parent), m_context(context), m_name(panelName), m_document(panelNamed(context, panelName)),
      m_palette(new Palette), m_canvas(new DesignCanvas(m_document, m_selection, context)),
      m_sheet(new PropertySheet(m_document, m_selection, context)),
      m_outline(new Outline(m_document, m_selection, context)), m_findingList(new QTreeWidget),
      m_pages(new QStackedWidget), m_where(new QLabel) {
    m_sheet->setPanelName(panelName);
    m_canvas->setPanelName(panelName);
    m_palette->setFaceplates(context.project().panels);
    m_context.openDocument(panelName, &m_document);
    makeActions();
    new kit::OwnKeys(this);
    setFocusProxy(m_canvas);
    m_pages->addWidget(m_canvas);
    m_findingList->setHeaderLabels({tr("Issue"), tr("Element"), tr("Language")});
    m_findingList->setRootIsDecorated(false);
    m_findingList->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_findingList->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_findingList->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    m_findingList->header()->setStretchLastSection(false);
    auto* middle = new QSplitter(Qt::Vertical);
    middle->addWidget(m_pages);
    middle->addWidget(m_findingList);
    middle->setStretchFactor(0, 6); // the list gives way as well where there is little room
    middle->setStretchFactor(1, 1);
    middle->setSizes({600, 110});
    auto* left = new QSplitter(Qt::Vertical);
    left->addWidget(makeSources());
    left->addWidget(m_outline);
    m_outline->setAccessibleName(tr("Outline"));
    m_canvas->setAccessibleName(tr("Panel"));
    left->setStretchFactor(0, 3);
    left->setStretchFactor(1, 2);
    auto* splitter = new QSplitter;
    splitter->addWidget(left);
    splitter->addWidget(middle);
    splitter->addWidget(m_sheet);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({210, 760, 300});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(makeToolBar());
    layout->addWidget(splitter, 1);

    connect(m_palette, &Palette::elementChosen, this,
            [this](const Json& fields) { m_canvas->insertElements(Json::array({fields}), m_canvas->visibleCenter()); });
    connect(m_canvas, &DesignCanvas::refused, this, &PanelDesigner::sayRefusal);
    connect(m_canvas, &DesignCanvas::contextMenuRequested, this, &PanelDesigner::showMenu);
    connect(m_canvas, &DesignCanvas::pointerMoved, this, [this](QPointF at) {
        m_where->setText(QStringLiteral("%1, %2").arg(std::lround(at.x())).arg(std::lround(at.y())));
    });
    connect(m_canvas, &DesignCanvas::editRequested, this, [this](const ElementId& id) {
        // A double click edits what the element is about: its text, else its binding.
        const Element* element = m_document.panel().find(id);
        if (element && element->kind() == ElementKind::Faceplate &&
            m_context.project().find(element->text("panel"_text)))
            emit panelRequested(element->text("panel"_text));
        for (const char* key : {"text", "target", "value", "title", "state"})
            if (element && element->descriptor().property(key))
                return m_sheet->grid().editProperty(QString::fromLatin1(key));
    });
    connect(m_findingList, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        const ElementId id = item->data(0, Qt::UserRole).toString();
        if (m_document.panel().find(id)) m_selection.set({id});
        if (const QString tag = item->text(2); !tag.isEmpty()) m_context.setLanguage(tag);
    });
    m_findingList->setAccessibleName(tr("Issues"));
    m_findingList->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_findingList, &QWidget::customContextMenuRequested, this, &PanelDesigner::showFindingMenu);
    connect(&m_document, &PanelDocument::changed, this, [this](const Touched& touched) {
        if (NamedPanel* panel = m_context.project().find(m_name)) panel->panel = m_document.panel();
        m_context.reportPanelEdited(m_name);
        if (m_player) m_player->follow(m_document.panel(), touched);
        m_checkTimer.start();
    });
    connect(&m_document.undoStack(), &QUndoStack::cleanChanged, this,
            [this](bool clean) { emit modifiedChanged(!clean); });
    connect(&m_context, &DesignContext::textsChanged, this, [this] {
        if (m_player) m_player->projectChanged();
        m_checkTimer.start();
    });
    connect(&m_context, &DesignContext::panelEdited, this, [this](const QString& name) {
        if (name == m_name) return;
        m_palette->setFaceplates(m_context.project().panels);
        m_sheet->refresh();
        if (m_player) m_player->follow(m_document.panel(), Touched{{}, true, false});
        m_checkTimer.start();
    });
    connect(&m_context, &DesignContext::languageChanged, this, [this] {
        if (m_player) m_player->setLanguage(m_context.language());
    });
    connect(&m_context, &DesignContext::programChanged, this, [this] {
        if (m_player && m_player->run() != m_context.run()) {
            m_player->setRun(m_context.run());
            showInPreview();
        }
        m_checkTimer.start();
    });
    connect(&m_context, &DesignContext::recordingChanged, this, &PanelDesigner::showInPreview);
    connect(&m_context, &DesignContext::positionChanged, this, [this] {
        if (m_player) m_player->setPosition(m_context.position());
    });
    connect(&m_selection, &Selection::changed, this, &PanelDesigner::updateActions);
    m_checkTimer.setSingleShot(true);
    m_checkTimer.setInterval(400);
    connect(&m_checkTimer, &QTimer::timeout, this, &PanelDesigner::checkNow);
    m_checkTimer.start();
    updateActions();
}

PanelDesigner::~PanelDesigner() {
    delete m_sheet; // a choice that is open in it would still ask for the document
    m_context.closeDocument(&m_document);
    m_document.disconnect(this);
    m_document.undoStack().disconnect(this);
}

/// What is dragged onto the panel: elements, and where the program is known, its variables.
QWidget* PanelDesigner::makeSources() {
    if (!m_context.variables()) return m_palette;
    auto* tabs = new QTabWidget;
    tabs->setDocumentMode(true);
    tabs->setAccessibleName(tr("Elements"));
    tabs->addTab(m_palette, tr("Elements"));
    m_variables = new kit::VariablePicker(m_context.variables()());
    m_variables->layout()->setContentsMargins(4, 4, 4, 4);
    tabs->addTab(m_variables, tr("Variables"));
    connect(m_variables, &kit::VariablePicker::picked, this, [this](const QString& path) {
        m_canvas->insertVariables({path}, m_canvas->visibleCenter(),
                                  QApplication::keyboardModifiers() & Qt::ShiftModifier);
    });
    const auto reload = [this] {
        if (!m_variables->isVisible()) return;
        (void)m_context.variables()();
        m_variables->reload();
    };
    connect(tabs, &QTabWidget::currentChanged, this, reload);
    connect(&m_context, &DesignContext::programChanged, this, reload);
    return tabs;
}

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
    add(QStringLiteral("paste-in-place"), tr("Paste in place"), Icon::Paste,
        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_V), [this] { paste(true); });
    add(QStringLiteral("duplicate"), tr("Duplicate"), Icon::Copy, QKeySequence(Qt::CTRL | Qt::Key_D),
        [this] { duplicate(); });
    add(QStringLiteral("duplicate-array"), tr("Duplicate as array…"), Icon::Table,
        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_D), [this] { duplicateAsArray(); });
    add(QStringLiteral("arrange-array"), tr("Arrange over array…"), Icon::Table, {}, [this] { arrangeOverArray(); });
    add(QStringLiteral("fix-all"), tr("Fix All Issues"), Icon::Build, {}, [this] { fixAll(); });
    add(QStringLiteral("select-all"), tr("Select all"), Icon::Select, QKeySequence::SelectAll, [this] { selectAll(); });
    addEdit(QStringLiteral("delete"), tr("Delete"), Icon::Delete, {}, [=] { return removeElements(panel(), ids()); });
    const std::tuple<const char*, QString, Icon, Alignment> alignments[] = {
        {"align-left", tr("Align left"), Icon::AlignLeft, Alignment::Left},
        {"align-center", tr("Align centres"), Icon::AlignCenter, Alignment::CenterX},
        {"align-right", tr("Align right"), Icon::AlignRight, Alignment::Right},
        {"align-top", tr("Align top"), Icon::AlignTop, Alignment::Top},
        {"align-middle", tr("Align middles"), Icon::AlignMiddle, Alignment::CenterY},
        {"align-bottom", tr("Align bottom"), Icon::AlignBottom, Alignment::Bottom}};
    for (const auto& [name, title, icon, alignment] : alignments)
        addEdit(QString::fromLatin1(name), title, icon, {},
                [=, how = alignment] { return align(panel(), ids(), how); });
    addEdit(QStringLiteral("distribute-x"), tr("Distribute horizontally"), Icon::DistributeX, {},
            [=] { return distribute(panel(), ids(), Direction::Horizontal); });
    addEdit(QStringLiteral("distribute-y"), tr("Distribute vertically"), Icon::DistributeY, {},
            [=] { return distribute(panel(), ids(), Direction::Vertical); });
    addEdit(QStringLiteral("same-width"), tr("Same width"), Icon::ZoomX, {},
            [=] { return makeSameSize(panel(), ids(), SameSize::Width); });
    addEdit(QStringLiteral("same-height"), tr("Same height"), Icon::ZoomY, {},
            [=] { return makeSameSize(panel(), ids(), SameSize::Height); });
    addEdit(QStringLiteral("same-size"), tr("Same size"), Icon::Fit, {},
            [=] { return makeSameSize(panel(), ids(), SameSize::Both); });
    addEdit(QStringLiteral("front"), tr("Bring to front"), Icon::BringFront,
            QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_BracketRight),
            [=] { return reorder(panel(), ids(), Order::Front); });
    addEdit(QStringLiteral("forward"), tr("Bring forward"), Icon::Up, QKeySequence(Qt::CTRL | Qt::Key_BracketRight),
            [=] { return reorder(panel(), ids(), Order::Forward); });
    addEdit(QStringLiteral("backward"), tr("Send backward"), Icon::Down, QKeySequence(Qt::CTRL | Qt::Key_BracketLeft),
            [=] { return reorder(panel(), ids(), Order::Backward); });
    addEdit(QStringLiteral("back"), tr("Send to back"), Icon::SendBack,
            QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_BracketLeft),
            [=] { return reorder(panel(), ids(), Order::Back); });
    add(QStringLiteral("group"), tr("Group"), Icon::Group, QKeySequence(Qt::CTRL | Qt::Key_G), [this] { group(); });
    add(QStringLiteral("ungroup"), tr("Ungroup"), Icon::Ungroup, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_G),
        [this] { ungroup(); });
    add(QStringLiteral("lay-row"), tr("Lay out in a row"), Icon::AlignMiddle, {}, [this] { layOut("row"); });
    add(QStringLiteral("lay-column"), tr("Lay out in a column"), Icon::AlignCenter, {}, [this] { layOut("column"); });
    add(QStringLiteral("lay-grid"), tr("Lay out in a grid"), Icon::Grid, {}, [this] { layOut("grid"); });
    addEdit(QStringLiteral("lock"), tr("Lock"), Icon::Lock, QKeySequence(Qt::CTRL | Qt::Key_L), [=] {
        bool all = true;
        for (const ElementId& id : ids()) all &= panel().find(id)->isSet("locked"_flag);
        return setLocked(panel(), ids(), !all);
    });
    QAction* grid =
        add(QStringLiteral("grid"), tr("Show the grid"), Icon::Grid, QKeySequence(Qt::CTRL | Qt::Key_Apostrophe),
            [this] { m_canvas->setGridShown(m_actions[QStringLiteral("grid")]->isChecked()); });
    QAction* snap = add(QStringLiteral("snap"), tr("Snap (Alt: not now)"), Icon::Magnet, {},
                        [this] { m_canvas->setSnapping(m_actions[QStringLiteral("snap")]->isChecked()); });
    QAction* live = add(QStringLiteral("live"), tr("Live preview"), Icon::Live, QKeySequence(Qt::Key_F6),
                        [this] { setLive(m_actions[QStringLiteral("live")]->isChecked()); });
    for (QAction* action : {grid, snap, live}) action->setCheckable(true);
    grid->setChecked(true);
    snap->setChecked(true);
    add(QStringLiteral("zoom-in"), tr("Zoom in"), Icon::ZoomIn, QKeySequence::ZoomIn,
        [this] { m_canvas->setZoom(m_canvas->zoom() * 1.25); });
    add(QStringLiteral("zoom-out"), tr("Zoom out"), Icon::ZoomOut, QKeySequence::ZoomOut,
        [this] { m_canvas->setZoom(m_canvas->zoom() / 1.25); });
    add(QStringLiteral("zoom-1"), tr("Zoom 100 %"), Icon::Find, QKeySequence(Qt::CTRL | Qt::Key_0),
        [this] { m_canvas->setZoom(1); });
    add(QStringLiteral("zoom-fit"), tr("Zoom to fit"), Icon::Fit, QKeySequence(Qt::CTRL | Qt::Key_9),
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

// ---- clipboard

void PanelDesigner::copy() {
    if (m_selection.isEmpty()) return;
    const std::string text = copied(m_document.panel(), m_selection.ids()).dump();
    auto* mime = new QMimeData;
    mime->setData(kElementMime, QByteArray::fromStdString(text));
    mime->setText(QString::fromStdString(text));
    QApplication::clipboard()->setMimeData(mime);
}

void PanelDesigner::cut() {
    copy();
    m_document.perform(tr("Cut"), removeElements(m_document.panel(), m_selection.ids()));
}

void PanelDesigner::paste(bool inPlace) {
    const QMimeData* mime = QApplication::clipboard()->mimeData();
    if (!mime || !mime->hasFormat(kElementMime)) return;
    const Json elements = readJson<Json>(mime->data(kElementMime).toStdString()).value;
    ElementIds added;
    const std::optional<QPointF> at = inPlace ? std::optional(boundsOf(elements).topLeft()) : std::nullopt;
    m_document.perform(tr("Paste"), pasted(m_document.panel(), elements, at, &added));
    m_selection.set(added);
}

void PanelDesigner::duplicate() {
    ElementIds added;
    m_document.perform(tr("Duplicate"),
                       pasted(m_document.panel(), copied(m_document.panel(), m_selection.ids()), std::nullopt, &added));
    m_selection.set(added);
}

void PanelDesigner::duplicateAsArray() {
    QString example;
    for (const ElementId& id : m_selection.ids())
        forEachBinding(*m_document.panel().find(id), [&](const Found& found) {
            if (example.isEmpty() && found.text.contains(u'[')) example = found.text;
        });
    ArrayDialog dialog(m_arrayLayout, example, this);
    if (dialog.exec() != QDialog::Accepted) return;
    m_arrayLayout = dialog.layoutChosen();
    ElementIds added;
    m_document.perform(tr("Duplicate as array"),
                       duplicatedAsArray(m_document.panel(), m_selection.ids(), m_arrayLayout, &added));
    ElementIds all = m_selection.ids();
    all.insert(all.end(), added.begin(), added.end());
    m_selection.set(all);
}

const Element* PanelDesigner::selectedFaceplate() const {
    if (m_selection.ids().size() != 1) return nullptr;
    const Element* element = m_document.panel().find(m_selection.ids().front());
    return element && element->kind() == ElementKind::Faceplate ? element : nullptr;
}

void PanelDesigner::arrangeOverArray() {
    const Element* faceplate = selectedFaceplate();
    if (!faceplate) return;
    const ElementId id = faceplate->id();
    ArrayArrangementDialog dialog(m_document.panel(), *faceplate, m_context, this);
    if (dialog.exec() != QDialog::Accepted) return;
    ElementIds all{id};
    m_document.perform(tr("Arrange over array"), arrangedOverArray(m_document.panel(), id, dialog.arrangement(), &all));
    m_selection.set(all);
}

/// What the canvas cannot do is said at the pointer.
void PanelDesigner::sayRefusal(const QString& reason) {
    QToolTip::showText(QCursor::pos(), reason, m_canvas);
    emit refused(reason);
}

void PanelDesigner::group() {
    ElementId id;
    m_document.perform(tr("Group"), makeGroup(m_document.panel(), m_selection.ids(), &id));
    m_selection.set({id});
}

void PanelDesigner::layOut(const char* layout) {
    if (m_selection.ids().empty()) return;
    ElementId id;
    m_document.perform(tr("Lay out"), hmi::layOut(m_document.panel(), m_selection.ids(), layout, &id));
    m_selection.set({id});
}

void PanelDesigner::ungroup() {
    ElementIds inside;
    for (const ElementId& id : m_selection.ids())
        for (const ElementId& child : m_document.panel().childrenOf(id)) inside.push_back(child);
    m_document.perform(tr("Ungroup"), dissolveGroups(m_document.panel(), m_selection.ids()));
    m_selection.set(inside);
}

void PanelDesigner::selectAll() {
    ElementIds ids;
    for (const Element& element : m_document.panel().elements())
        if (element.parent().isEmpty() && !element.isSet("locked"_flag)) ids.push_back(element.id());
    m_selection.set(ids);
}

// ---- preview, check, save

void PanelDesigner::setLive(bool live) {
    m_actions[QStringLiteral("live")]->setChecked(live);
    if (live == isLive()) return;
    if (!live) {
        m_pages->setCurrentWidget(m_canvas);
        m_player.reset();
        return;
    }
    m_player = std::make_unique<PanelPlayer>(m_context.project(), m_context.run());
    // A faceplate by itself shows the first thing that it stands for.
    if (const auto given = argumentsGiven(m_context.checkInput(), m_name); !given.empty())
        m_player->setArguments(given.front());
    m_player->showPanel(m_name, m_document.panel());
    m_player->setLanguage(m_context.language());
    showInPreview();
    connect(m_player.get(), &PanelPlayer::languageChanged, &m_context, &DesignContext::setLanguage);
    m_pages->addWidget(m_player.get());
    m_pages->setCurrentWidget(m_player.get());
}

/// The preview shows what the rest of the studio shows.
void PanelDesigner::showInPreview() {
    if (!m_player) return;
    m_player->setRecording(m_context.recording());
    m_player->setPosition(m_context.position());
}

void PanelDesigner::checkNow() {
    m_checkTimer.stop();
    m_findings = checkPanel(m_context.checkInput(), NamedPanel{m_name, m_document.panel()});
    m_canvas->setFindings(m_findings);
    action(QStringLiteral("fix-all"))
        ->setEnabled(
            std::any_of(m_findings.begin(), m_findings.end(), [](const Finding& one) { return !one.fix.isEmpty(); }));
    showFindings();
    emit findingsChanged();
}

void PanelDesigner::showFindings() {
    m_findingList->clear();
    for (const Finding& finding : m_findings) {
        auto* item = new QTreeWidgetItem(
            m_findingList,
            {finding.code() + QStringLiteral("  ") + kit::messageText(finding.message),
             finding.element + (finding.property.isEmpty() ? QString() : u'.' + finding.property), finding.language});
        item->setIcon(0, kit::icon(finding.isError ? kit::Icon::Error : kit::Icon::Warning));
        item->setData(0, Qt::UserRole, finding.element);
        item->setToolTip(0, kit::messageText(finding.why));
    }
    m_findingList->resizeColumnToContents(1);
}

void PanelDesigner::fixFinding(size_t index) {
    if (index < m_findings.size() && !m_findings[index].fix.isEmpty())
        m_document.perform(tr("Fix Issue"), m_findings[index].fix);
    checkNow();
}

void PanelDesigner::fixAll() {
    const QString file = QStringLiteral("hmi/%1.panel.json").arg(m_name);
    if (const Edit edit = fixesOf(m_findings, file); !edit.isEmpty()) m_document.perform(tr("Fix All Issues"), edit);
    checkNow();
}

void PanelDesigner::showFindingMenu(QPoint at) {
    const int row = m_findingList->indexOfTopLevelItem(m_findingList->itemAt(at));
    const bool isFinding = row >= 0 && row < static_cast<int>(m_findings.size());
    QMenu menu;
    QAction* fix = menu.addAction(tr("Fix Issue"), this, [this, row] { fixFinding(static_cast<size_t>(row)); });
    fix->setEnabled(isFinding && !m_findings[static_cast<size_t>(row)].fix.isEmpty());
    menu.addAction(action(QStringLiteral("fix-all")));
    if (isFinding && !m_findings[static_cast<size_t>(row)].why.isEmpty()) {
        const Message why = m_findings[static_cast<size_t>(row)].why;
        menu.addAction(tr("Explain Issue"), this, [this, why, at] {
            QToolTip::showText(m_findingList->viewport()->mapToGlobal(at), kit::messageText(why), m_findingList);
        });
    }
    menu.exec(m_findingList->viewport()->mapToGlobal(at));
}

Result<void> PanelDesigner::save() {
    if (auto saved = savePanel(m_context.project(), NamedPanel{m_name, m_document.panel()}); !saved) return saved;
    if (auto saved = m_context.save(); !saved) return saved;
    m_document.setClean();
    return {};
}

void PanelDesigner::reload(const Panel& panel) {
    m_document.reset(panel);
    m_selection.prune(panel);
}

} // namespace plc::hmi
