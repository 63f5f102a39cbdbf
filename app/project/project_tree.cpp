#include "app/project/project_tree.h"

#include "app/settings/settings.h"
#include "editor/kit/icons.h"
#include "editor/kit/inputs/variable_picker.h"
#include "editor/kit/theme.h"
#include "runtime/base/text.h"

#include <QFileInfo>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace plc::app {

using kit::Icon;
using sema::SymbolKind;

namespace {
/// Variables leave it as paths for watch, trace and panel, and as their name for the text.
class VariableTree : public QTreeWidget {
public:
    VariableTree(QWidget* parent, int kindRole, int pathRole)
        : QTreeWidget(parent), m_kind(kindRole), m_path(pathRole) {
        setDragEnabled(true);
        setDragDropMode(DragOnly);
    }

protected:
    QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override {
        QStringList paths, names;
        for (const QTreeWidgetItem* item : items) {
            const QString kind = item->data(0, m_kind).toString();
            if (kind == "variable") paths << item->data(0, m_path).toString();
            if (kind == "variable" || kind == "unit" || kind == "libraryUnit") names << item->text(0);
        }
        if (names.isEmpty()) return nullptr;
        QMimeData* mime = paths.isEmpty() ? new QMimeData : kit::makeVariableMime(paths);
        mime->setText(names.join('\n'));
        return mime;
    }

private:
    int m_kind, m_path;
};

/// The file a unit stands in, muted behind its name while there is room.
class NoteDelegate : public QStyledItemDelegate {
public:
    NoteDelegate(QObject* parent, int noteRole) : QStyledItemDelegate(parent), m_note(noteRole) {}
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        const QString note = index.data(m_note).toString();
        if (note.isEmpty()) return;
        const QRect area = option.rect.adjusted(option.decorationSize.width() + 14 +
                                                    option.fontMetrics.horizontalAdvance(index.data().toString()) + 10,
                                                0, -4, 0);
        if (area.width() < 30) return;
        painter->save();
        painter->setPen(kit::colors().muted);
        painter->drawText(area, Qt::AlignVCenter | Qt::AlignLeft,
                          option.fontMetrics.elidedText(note, Qt::ElideMiddle, area.width()));
        painter->restore();
    }

private:
    int m_note;
};

/// The template a group's "New…" begins with.
QString templateOf(const QString& kind) {
    return kind == "group:blocks"       ? "block"
           : kind == "group:functions"  ? "function"
           : kind == "group:types"      ? "struct"
           : kind == "group:globals"    ? "globals"
           : kind == "group:simulation" ? "simulation"
           : kind == "group:tests"      ? "test"
                                        : "program";
}
} // namespace

ProjectTree::ProjectTree(editor::Workspace& workspace, QWidget* parent) : QWidget(parent), m_workspace(workspace) {
    m_tree = new VariableTree(this, Kind, Path);
    m_tree->setHeaderHidden(true);
    m_tree->setUniformRowHeights(true);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    m_tree->setAccessibleName(tr("Project"));
    m_tree->setItemDelegate(new NoteDelegate(m_tree, Note));
    m_tree->installEventFilter(this);
    m_filter = new QLineEdit(this);
    m_filter->setPlaceholderText(tr("Filter"));
    m_filter->setClearButtonEnabled(true);
    m_filter->setAccessibleName(tr("Filter of the project tree"));
    m_byFile = new QToolButton(this);
    m_byFile->setIcon(kit::icon(Icon::File));
    m_byFile->setCheckable(true);
    m_byFile->setAutoRaise(true);
    m_byFile->setToolTip(tr("Arrange by file"));
    m_byFile->setAccessibleName(m_byFile->toolTip());
    m_byFile->setChecked(Settings().arrangesByFile());
    connect(m_byFile, &QToolButton::toggled, this, [this](bool on) {
        Settings().setArrangesByFile(on);
        m_shape.clear();
        reload();
    });
    auto* top = new QHBoxLayout;
    top->setSpacing(2);
    top->addWidget(m_filter);
    top->addWidget(m_byFile);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(top);
    layout->addWidget(m_tree);
    connect(m_tree, &QTreeWidget::itemActivated, this, &ProjectTree::activate);
    connect(m_tree, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item) {
        const QString kind = item->data(0, Kind).toString();
        if (item->childCount() == 0 || kind == "unit" || kind == "file") activate(item);
    });
    connect(m_tree, &QTreeWidget::itemCollapsed, this,
            [this](QTreeWidgetItem* item) { m_collapsed << item->data(0, Name).toString(); });
    connect(m_tree, &QTreeWidget::itemExpanded, this,
            [this](QTreeWidgetItem* item) { m_collapsed.removeAll(item->data(0, Name).toString()); });
    connect(m_tree, &QTreeWidget::customContextMenuRequested, this, &ProjectTree::showMenu);
    connect(m_filter, &QLineEdit::textChanged, this, &ProjectTree::filter);
    connect(&workspace, &editor::Workspace::analysed, this, &ProjectTree::reload);
    connect(&workspace, &editor::Workspace::filesChanged, this, &ProjectTree::reload);
    connect(&workspace, &editor::Workspace::closed, this, &ProjectTree::reload);
    connect(&workspace, &editor::Workspace::modificationChanged, this, &ProjectTree::markChanged);
}

/// A dot where the file holds something that is not saved, also when no tab of it is open.
void ProjectTree::markChanged() {
    const QStringList changed = m_workspace.isOpen() ? m_workspace.modifiedFiles() : QStringList();
    const QString dot = QStringLiteral(" ●");
    const auto mark = [&](auto&& self, QTreeWidgetItem* item) -> void {
        if (const QString file = item->data(0, File).toString(); item->data(0, Note).isValid()) {
            QString note = item->data(0, Note).toString();
            if (note.endsWith(dot)) note.chop(dot.size());
            item->setData(0, Note, changed.contains(file) ? note + dot : note);
        }
        for (int i = 0; i < item->childCount(); ++i) self(self, item->child(i));
    };
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) mark(mark, m_tree->topLevelItem(i));
}

bool ProjectTree::isByFile() const { return m_byFile->isChecked(); }

QTreeWidgetItem* ProjectTree::group(const QString& title, int icon, const QString& key) {
    auto* item = new QTreeWidgetItem(m_tree, {title});
    item->setIcon(0, kit::icon(static_cast<Icon>(icon)));
    item->setData(0, Kind, "group:" + key);
    item->setData(0, Name, key);
    return item;
}

namespace {
Icon iconOf(SymbolKind kind) {
    switch (kind) {
    case SymbolKind::Program:
        return Icon::Program;
    case SymbolKind::Function:
        return Icon::Function;
    case SymbolKind::FunctionBlock:
        return Icon::Block;
    case SymbolKind::Method:
        return Icon::Method;
    case SymbolKind::Property:
        return Icon::Property;
    case SymbolKind::Action:
        return Icon::Action;
    case SymbolKind::Interface:
        return Icon::Interface;
    case SymbolKind::Type:
        return Icon::Structure;
    case SymbolKind::Step:
        return Icon::Sfc;
    case SymbolKind::Task:
        return Icon::Task;
    case SymbolKind::GlobalList:
        return Icon::Globals;
    case SymbolKind::Namespace:
        return Icon::Namespace;
    default:
        return Icon::Variable;
    }
}
} // namespace

void ProjectTree::addUnit(QTreeWidgetItem* parent, const analysis::OutlineItem& unit, const QString& file) {
    auto* item = new QTreeWidgetItem(parent, {QString::fromStdString(unit.name)});
    item->setIcon(0, kit::icon(unit.isSimulation ? Icon::Simulation : unit.isTest ? Icon::Test : iconOf(unit.kind)));
    item->setData(0, Kind, "unit");
    item->setData(0, File, file);
    item->setData(0, Offset, unit.nameRange.begin);
    item->setData(0, EndOffset, unit.range.end);
    item->setData(0, Name, file + "/" + QString::fromStdString(unit.name));
    item->setToolTip(0, file);
    const bool isTop = parent->data(0, Kind).toString().startsWith("group:") && !isByFile();
    if (isTop) item->setData(0, Note, QFileInfo(file).fileName());
    bool hasSteps = false;
    for (const analysis::OutlineItem& child : unit.children) {
        if (child.kind == SymbolKind::Step) {
            hasSteps = true;
            continue;
        }
        addUnit(item, child, file);
    }
    addVariables(item, unit.kind == SymbolKind::GlobalList ? std::string() : unit.name, file);
    if (hasSteps) {
        auto* chart = new QTreeWidgetItem(item, {tr("Chart")});
        chart->setIcon(0, kit::icon(Icon::Sfc));
        chart->setData(0, Kind, "chart");
        chart->setData(0, File, file);
        chart->setData(0, Name, QString::fromStdString(unit.name));
    }
}

void ProjectTree::addVariables(QTreeWidgetItem* parent, const std::string& owner, const QString& file) {
    const auto found = m_variables.find(foldCase(owner));
    if (found == m_variables.end()) return;
    const auto& model = *m_workspace.model();
    for (const sema::Symbol* symbol : found->second) {
        // Globals belong to the list they stand in.
        if (owner.empty() && (QString::fromStdString(model.sources()[symbol->declaration.file].path()) != file ||
                              symbol->declaration.begin < parent->data(0, Offset).toUInt() ||
                              symbol->declaration.begin >= parent->data(0, EndOffset).toUInt()))
            continue;
        auto* item = new QTreeWidgetItem(parent, {QString::fromStdString(symbol->name)});
        item->setIcon(0, kit::icon(symbol->isConstant ? Icon::Constant : Icon::Variable));
        item->setData(0, Kind, "variable");
        item->setData(0, File, QString::fromStdString(model.sources()[symbol->declaration.file].path()));
        item->setData(0, Offset, symbol->declaration.begin);
        item->setData(0, Name, file + "/" + QString::fromStdString(owner + "." + symbol->name));
        item->setData(0, Path, QString::fromStdString(symbol->path.empty() ? symbol->name : symbol->path));
        QString tip = QString::fromStdString(symbol->path.empty() ? symbol->name : symbol->path);
        if (symbol->type.isValid() && model.checked().analysis->program)
            tip += " : " + QString::fromStdString((*model.checked().analysis->program->types)[symbol->type].name);
        if (!symbol->comment.empty()) tip += "\n" + QString::fromStdString(symbol->comment);
        item->setToolTip(0, tip);
    }
}

namespace {

/// The group of the tree that a unit is shown in; "" for what is in none.
QString groupOf(const analysis::OutlineItem& item) {
    if (item.isSimulation) return QStringLiteral("simulation");
    switch (item.kind) {
    case SymbolKind::Program:
        return QStringLiteral("programs");
    case SymbolKind::FunctionBlock:
    case SymbolKind::Interface:
        return QStringLiteral("blocks");
    case SymbolKind::Function:
        return QStringLiteral("functions");
    case SymbolKind::Type:
        return QStringLiteral("types");
    case SymbolKind::GlobalList:
        return QStringLiteral("globals");
    case SymbolKind::Task:
        return QStringLiteral("tasks");
    case SymbolKind::Variable:
    case SymbolKind::Constant:
    case SymbolKind::Enumerator:
    case SymbolKind::Method:
    case SymbolKind::Property:
    case SymbolKind::Action:
    case SymbolKind::Namespace:
    case SymbolKind::Label:
    case SymbolKind::Step:
    case SymbolKind::StandardFunction:
        break;
    }
    return {};
}

} // namespace

void ProjectTree::reload() {
    if (!m_workspace.isOpen() || !m_workspace.model()) {
        m_tree->clear();
        m_shape.clear();
        return;
    }
    const Units units = unitsByGroup();
    gatherVariables();
    const QString shape = shapeOf(units);
    if (shape == m_shape) {
        m_variables.clear();
        return;
    }
    m_shape = shape;
    m_tree->clear();
    if (isByFile())
        addFiles();
    else
        addUnits(units);
    addDesigns();
    addTests();
    addLibraries();
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = m_tree->topLevelItem(i);
        if (!m_collapsed.contains(item->data(0, Name).toString())) item->setExpanded(true);
        if (item->childCount() == 0 && item->data(0, Kind).toString().startsWith("group:"))
            item->setForeground(0, kit::colors().muted);
    }
    m_variables.clear();
    markChanged();
    filter(m_filter->text());
}

ProjectTree::Units ProjectTree::unitsByGroup() const {
    const auto& model = *m_workspace.model();
    Units units;
    for (const QString& file : m_workspace.files()) {
        if (m_workspace.isTestFile(file)) continue;
        const auto id = model.fileOf(file.toStdString());
        if (!id) continue;
        const auto place = [&](auto&& self, const std::vector<analysis::OutlineItem>& items) -> void {
            for (const analysis::OutlineItem& item : items) {
                if (item.kind == SymbolKind::Namespace) self(self, item.children);
                if (const QString key = groupOf(item); !key.isEmpty()) units[key].push_back({file, item});
            }
        };
        place(place, model.outline(*id));
    }
    return units;
}

/// By owner, those that the user has written in files of the project.
void ProjectTree::gatherVariables() {
    const auto& model = *m_workspace.model();
    m_variables.clear();
    for (const sema::Symbol& symbol : model.checked().analysis->symbols) {
        if ((symbol.kind != SymbolKind::Variable && symbol.kind != SymbolKind::Constant) ||
            !symbol.declaration.file.isValid() || symbol.name.starts_with("__")) // what the compiler adds
            continue;
        if (!m_workspace.files().contains(QString::fromStdString(model.sources()[symbol.declaration.file].path())))
            continue;
        m_variables[foldCase(symbol.owner)].push_back(&symbol);
    }
}

/// Everything that the tree shows: while this stays the same, no row is made again.
QString ProjectTree::shapeOf(const Units& units) const {
    QString shape;
    for (const auto& [key, parts] : units)
        for (const Unit& each : parts)
            shape += key + each.file + QString::fromStdString(each.item.name) +
                     QString::number(each.item.nameRange.begin) + QString::number(each.item.children.size());
    for (const auto& [owner, variables] : m_variables)
        for (const sema::Symbol* symbol : variables)
            shape +=
                QString::fromStdString(symbol->owner + "." + symbol->name) + QString::number(symbol->declaration.begin);
    const projects::Project& project = m_workspace.project();
    for (const auto* list : {&project.panels, &project.traces, &project.libraries})
        for (const std::string& name : *list) shape += QString::fromStdString(name);
    shape += m_workspace.files().join('|') + m_workspace.folder();
    return shape + (isByFile() ? "|by file" : "");
}

void ProjectTree::addUnits(const Units& units) {
    const auto fill = [&](const QString& title, Icon icon, const QString& key) {
        QTreeWidgetItem* parent = group(title, static_cast<int>(icon), key);
        if (const auto found = units.find(key); found != units.end())
            for (const Unit& each : found->second) addUnit(parent, each.item, each.file);
    };
    fill(tr("Programs"), Icon::Program, "programs");
    fill(tr("Blocks"), Icon::Block, "blocks");
    fill(tr("Functions"), Icon::Function, "functions");
    fill(tr("Types"), Icon::Structure, "types");
    fill(tr("Globals"), Icon::Globals, "globals");
    fill(tr("Tasks"), Icon::Task, "tasks");
    fill(tr("Simulation"), Icon::Simulation, "simulation");
}

/// Panels and what belongs to them, devices, traces.
void ProjectTree::addDesigns() {
    const auto names = [&](QTreeWidgetItem* parent, const std::vector<std::string>& list, const QString& kind,
                           Icon icon, const QString& ending) {
        for (const std::string& name : list) {
            QString shown = QString::fromStdString(name);
            if (shown.endsWith(ending)) shown.chop(ending.size());
            auto* item = new QTreeWidgetItem(parent, {shown});
            item->setIcon(0, kit::icon(icon));
            item->setData(0, Kind, kind);
            item->setData(0, Name, shown);
        }
    };
    const auto single = [&](const QString& title, Icon icon, const char* kind) {
        auto* item = new QTreeWidgetItem(m_tree, {title});
        item->setIcon(0, kit::icon(icon));
        item->setData(0, Kind, kind);
    };
    const projects::Project& project = m_workspace.project();
    names(group(tr("Panels"), static_cast<int>(Icon::Panel), "panels"), project.panels, "panel", Icon::Panel,
          ".panel.json");
    single(tr("Texts"), Icon::Texts, "texts");
    single(tr("Alarms"), Icon::Alarm, "alarms");
    single(tr("Recipes"), Icon::Table, "recipes");
    single(tr("Users and Rights"), Icon::User, "people");
    single(tr("Panel Themes"), Icon::Theme, "themes");
    single(tr("Devices"), Icon::Link, "devices");
    names(group(tr("Traces"), static_cast<int>(Icon::Trace), "traces"), project.traces, "trace", Icon::Trace,
          ".trace.json");
}

void ProjectTree::addTests() {
    QTreeWidgetItem* tests = group(tr("Tests"), static_cast<int>(Icon::Test), "tests");
    for (const QString& file : m_workspace.files()) {
        if (!m_workspace.isTestFile(file)) continue;
        auto* item = new QTreeWidgetItem(tests, {QFileInfo(file).fileName()});
        item->setIcon(0, kit::icon(Icon::Test));
        item->setData(0, Kind, "unit");
        item->setData(0, File, file);
        item->setData(0, Offset, 0u);
        item->setData(0, Name, file);
        item->setData(0, Note, QString(""));
    }
}

/// Source files in order, each with its units.
void ProjectTree::addFiles() {
    const auto& model = *m_workspace.model();
    QTreeWidgetItem* parent = group(tr("Files"), static_cast<int>(Icon::Folder), "files");
    for (const QString& file : m_workspace.files()) {
        if (m_workspace.isTestFile(file)) continue;
        auto* item = new QTreeWidgetItem(parent, {file.startsWith("src/") ? file.mid(4) : file});
        item->setIcon(0, kit::icon(Icon::File));
        item->setData(0, Kind, "file");
        item->setData(0, File, file);
        item->setData(0, Offset, 0u);
        item->setData(0, Name, "file:" + file);
        item->setData(0, Note, QString("")); // room for the dot of a changed file
        item->setToolTip(0, m_workspace.absolutePath(file));
        if (const auto id = model.fileOf(file.toStdString()))
            for (const analysis::OutlineItem& unit : model.outline(*id)) addUnit(item, unit, file);
        if (!m_collapsed.contains("file:" + file)) item->setExpanded(true);
    }
}

/// What each library offers; a click shows its source.
void ProjectTree::addLibraries() {
    const auto& model = *m_workspace.model();
    QTreeWidgetItem* parent = group(tr("Libraries"), static_cast<int>(Icon::Library), "libraries");
    std::vector<std::string> libraries = m_workspace.project().libraries;
    if (std::find(libraries.begin(), libraries.end(), "standard") == libraries.end())
        libraries.insert(libraries.begin(), "standard"); // always there
    for (const std::string& name : libraries) {
        auto* item = new QTreeWidgetItem(parent, {QString::fromStdString(name)});
        item->setIcon(0, kit::icon(Icon::Library));
        item->setData(0, Kind, "library");
        item->setData(0, Name, "library:" + QString::fromStdString(name));
        const auto& files = model.checked().analysis->files;
        for (size_t i = 0; i < files.size(); ++i) {
            if (!equalsIgnoringCase(files[i]->library, name)) continue;
            const QString file = QString::fromStdString(model.sources()[FileId(i)].path());
            for (const analysis::OutlineItem& unit : model.outline(FileId(i))) {
                if (unit.isHidden || unit.name.empty() || unit.name.starts_with("__")) continue;
                auto* child = new QTreeWidgetItem(item, {QString::fromStdString(unit.name)});
                child->setIcon(0, kit::icon(iconOf(unit.kind)));
                child->setData(0, Kind, "libraryUnit");
                child->setData(0, File, file);
                child->setData(0, Offset, unit.nameRange.begin);
                child->setToolTip(0, QString::fromStdString(unit.comment));
            }
        }
        item->sortChildren(0, Qt::AscendingOrder);
    }
}

void ProjectTree::activate(QTreeWidgetItem* item) {
    const QString kind = item->data(0, Kind).toString();
    if (kind == "unit" || kind == "variable" || kind == "file" || kind == "libraryUnit")
        emit placeRequested(item->data(0, File).toString(), item->data(0, Offset).toUInt());
    else if (kind == "chart")
        emit chartRequested(item->data(0, File).toString(), item->data(0, Name).toString());
    else if (kind == "panel")
        emit panelRequested(item->data(0, Name).toString());
    else if (kind == "trace")
        emit traceRequested(item->data(0, Name).toString());
    else if (kind == "texts")
        emit textsRequested();
    else if (kind == "alarms")
        emit alarmsRequested();
    else if (kind == "recipes")
        emit recipesRequested();
    else if (kind == "people")
        emit peopleRequested();
    else if (kind == "themes")
        emit themesRequested();
    else if (kind == "devices")
        emit devicesRequested();
    else if (kind == "library")
        emit librariesRequested();
}

QString ProjectTree::focusedVariable() const {
    const QTreeWidgetItem* item = m_tree->hasFocus() ? m_tree->currentItem() : nullptr;
    return item && item->data(0, Kind).toString() == "variable" ? item->data(0, Path).toString() : QString();
}

void ProjectTree::showMenu(const QPoint& position) {
    // The tree may be made anew while the menu is open: the entries find their item again.
    const QPersistentModelIndex at = m_tree->indexAt(position);
    const auto here = [this, at] { return at.isValid() ? m_tree->itemAt(m_tree->visualRect(at).center()) : nullptr; };
    QTreeWidgetItem* item = m_tree->itemAt(position);
    const QString kind = item ? item->data(0, Kind).toString() : QString();
    const QString file = item ? item->data(0, File).toString() : QString();
    QMenu menu(this);
    connect(menu.addAction(kit::icon(Icon::New), tr("New…")), &QAction::triggered, this, [this, kind, file] {
        if (kind == "panel" || kind == "group:panels")
            emit newPanelRequested();
        else if (kind == "trace" || kind == "group:traces")
            emit newTraceRequested();
        else
            emit newUnitRequested(templateOf(kind), kind == "file" ? file : QString());
    });
    if (item && !kind.startsWith("group:")) {
        connect(menu.addAction(kit::icon(Icon::Open), tr("Open")), &QAction::triggered, this, [this, here] {
            if (QTreeWidgetItem* found = here()) activate(found);
        });
    }
    if (kind == "unit" || kind == "variable" || kind == "panel" || kind == "trace" || kind == "file") {
        connect(menu.addAction(kit::icon(Icon::Rename), tr("Rename…")), &QAction::triggered, this, [this, here] {
            if (QTreeWidgetItem* found = here()) rename(found);
        });
    }
    if (kind == "unit" || kind == "panel" || kind == "trace" || kind == "file") {
        connect(menu.addAction(kit::icon(Icon::Delete), tr("Delete…")), &QAction::triggered, this, [this, here] {
            if (QTreeWidgetItem* found = here()) remove(found);
        });
    }
    if (kind == "variable") {
        const QString path = item->data(0, Path).toString();
        connect(menu.addAction(kit::icon(Icon::Watch), tr("Watch")), &QAction::triggered, this,
                [this, path] { emit watchRequested(path); });
        kit::addWhyActions(menu, [this, path](kit::AskWhy question) { emit whyRequested(question, path); });
    }
    if (item) addInstances(menu, *item);
    connect(menu.addAction(kit::icon(Icon::Library), tr("Libraries…")), &QAction::triggered, this,
            &ProjectTree::librariesRequested);
    connect(menu.addAction(kit::icon(Icon::Test), tr("Run Tests")), &QAction::triggered, this,
            &ProjectTree::testsRequested);
    menu.exec(m_tree->viewport()->mapToGlobal(position));
}

void ProjectTree::setInstances(InstanceAt at, InstancesOf of) {
    m_instanceAt = std::move(at);
    m_instancesOf = std::move(of);
}

/// Of a variable the instance it is or lies in; of a block all that it has, as far as a menu holds them.
void ProjectTree::addInstances(QMenu& menu, const QTreeWidgetItem& item) {
    constexpr size_t kMost = 40;
    const QString kind = item.data(0, Kind).toString();
    if (kind == "variable" && m_instanceAt) {
        const auto [block, instance] = m_instanceAt(item.data(0, Path).toString());
        if (block.isEmpty()) return;
        connect(menu.addAction(kit::icon(Icon::Forward), tr("Source of %1 with the Values of %2").arg(block, instance)),
                &QAction::triggered, this,
                [this, block = block, instance = instance] { emit instanceRequested(block, instance); });
        return;
    }
    if (kind != "unit" || !m_instancesOf) return;
    const QString block = item.text(0);
    const std::vector<QString> all = m_instancesOf(block);
    if (all.empty() || (all.size() == 1 && all[0] == block)) return; // a program is its own
    QMenu* instances = menu.addMenu(kit::icon(Icon::Forward), tr("Values of Instance"));
    for (size_t i = 0; i < std::min(all.size(), kMost); ++i)
        connect(instances->addAction(all[i]), &QAction::triggered, this,
                [this, block, instance = all[i]] { emit instanceRequested(block, instance); });
    if (all.size() > kMost) instances->addAction(tr("More: choose in the watch"))->setEnabled(false);
}

void ProjectTree::rename(QTreeWidgetItem* item) {
    const QString kind = item->data(0, Kind).toString(), file = item->data(0, File).toString();
    if (kind == "panel" || kind == "trace")
        emit renameFileRequested(kind, item->data(0, Name).toString());
    else if (kind == "unit" && editor::Workspace::isTestFile(file))
        emit renameFileRequested("test", file);
    else if (kind == "file")
        emit renameFileRequested("source", file);
    else if (kind == "unit" || kind == "variable")
        emit renameRequested(file, item->data(0, Offset).toUInt());
}

void ProjectTree::remove(QTreeWidgetItem* item) {
    const QString kind = item->data(0, Kind).toString(), file = item->data(0, File).toString();
    if (kind == "panel" || kind == "trace")
        emit deleteFileRequested(kind, item->data(0, Name).toString());
    else if (kind == "unit" && editor::Workspace::isTestFile(file))
        emit deleteFileRequested("test", file);
    else if (kind == "file")
        emit deleteFileRequested("source", file);
    else if (kind == "unit")
        emit deleteRequested(file, item->data(0, Offset).toUInt(), item->data(0, EndOffset).toUInt(), item->text(0));
}

bool ProjectTree::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey =
        watched == m_tree && (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride);
    if (!isKey || !m_tree->currentItem()) return QWidget::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->modifiers() != Qt::NoModifier || (key->key() != Qt::Key_F2 && key->key() != Qt::Key_Delete))
        return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::ShortcutOverride) { // F2 here is the tree's, not the editor's
        event->accept();
        return true;
    }
    if (key->key() == Qt::Key_F2)
        rename(m_tree->currentItem());
    else
        remove(m_tree->currentItem());
    return true;
}

void ProjectTree::filter(const QString& text) {
    const auto apply = [&](auto&& self, QTreeWidgetItem* item) -> bool {
        bool any = text.isEmpty() || item->text(0).contains(text, Qt::CaseInsensitive);
        for (int i = 0; i < item->childCount(); ++i) any = self(self, item->child(i)) || any;
        item->setHidden(!any);
        return any;
    };
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) apply(apply, m_tree->topLevelItem(i));
}

} // namespace plc::app
