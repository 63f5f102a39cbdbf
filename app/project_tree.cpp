#include "app/project_tree.h"

#include "editor/kit/icons.h"
#include "editor/kit/theme.h"
#include "editor/kit/variable_picker.h"
#include "runtime/base/text.h"

#include <QFileInfo>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QVBoxLayout>

namespace plc::app {

using kit::Icon;
using sema::SymbolKind;

namespace {
/// Variables are dragged by their paths: to charts, watches, panels.
class Tree final : public QTreeWidget {
public:
    Tree(int kind, int name, QWidget* parent) : QTreeWidget(parent), m_kind(kind), m_name(name) {}

protected:
    QStringList mimeTypes() const override { return {kit::VariableMime}; }
    QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override {
        QStringList paths;
        for (const QTreeWidgetItem* item : items)
            if (item->data(0, m_kind).toString() == "variable") paths << item->data(0, m_name).toString();
        return paths.isEmpty() ? nullptr : kit::makeVariableMime(paths);
    }

private:
    int m_kind, m_name;
};
} // namespace

ProjectTree::ProjectTree(editor::Workspace& workspace, QWidget* parent) : QWidget(parent), m_workspace(workspace) {
    m_tree = new Tree(Kind, Name, this);
    m_tree->setHeaderHidden(true);
    m_tree->setUniformRowHeights(true);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    m_tree->setAccessibleName(tr("Project"));
    m_tree->setDragEnabled(true);
    m_tree->setDragDropMode(QAbstractItemView::DragOnly);
    m_filter = new QLineEdit(this);
    m_filter->setPlaceholderText(tr("Filter"));
    m_filter->setClearButtonEnabled(true);
    m_filter->setAccessibleName(tr("Filter of the project tree"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_filter);
    layout->addWidget(m_tree);
    connect(m_tree, &QTreeWidget::itemActivated, this, &ProjectTree::activate);
    connect(m_tree, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item) {
        if (item->childCount() == 0 || item->data(0, Kind).toString() == "unit") activate(item);
    });
    connect(m_tree, &QTreeWidget::itemCollapsed, this, [this](QTreeWidgetItem* item) { m_collapsed << item->data(0, Name).toString(); });
    connect(m_tree, &QTreeWidget::itemExpanded, this, [this](QTreeWidgetItem* item) { m_collapsed.removeAll(item->data(0, Name).toString()); });
    connect(m_tree, &QTreeWidget::customContextMenuRequested, this, &ProjectTree::showMenu);
    connect(m_filter, &QLineEdit::textChanged, this, &ProjectTree::filter);
    connect(&workspace, &editor::Workspace::analysed, this, &ProjectTree::reload);
    connect(&workspace, &editor::Workspace::filesChanged, this, &ProjectTree::reload);
    connect(&workspace, &editor::Workspace::closed, this, &ProjectTree::reload);
}

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
    case SymbolKind::Program: return Icon::Program;
    case SymbolKind::Function: return Icon::Function;
    case SymbolKind::FunctionBlock: return Icon::Block;
    case SymbolKind::Method: return Icon::Method;
    case SymbolKind::Property: return Icon::Property;
    case SymbolKind::Action: return Icon::Action;
    case SymbolKind::Interface: return Icon::Interface;
    case SymbolKind::Type: return Icon::Structure;
    case SymbolKind::Step: return Icon::Sfc;
    case SymbolKind::Task: return Icon::Task;
    case SymbolKind::GlobalList: return Icon::Globals;
    case SymbolKind::Namespace: return Icon::Namespace;
    default: return Icon::Variable;
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
    bool hasSteps = false;
    for (const analysis::OutlineItem& child : unit.children) {
        if (child.kind == SymbolKind::Step) {
            hasSteps = true;
            continue;
        }
        addUnit(item, child, file);
    }
    if (hasSteps) {
        auto* chart = new QTreeWidgetItem(item, {tr("Chart")});
        chart->setIcon(0, kit::icon(Icon::Sfc));
        chart->setData(0, Kind, "chart");
        chart->setData(0, File, file);
        chart->setData(0, Name, QString::fromStdString(unit.name));
    }
    if (unit.kind != SymbolKind::Program && unit.kind != SymbolKind::GlobalList) return;
    for (const sema::Symbol* symbol : variablesIn(unit, file)) {
        auto* variable = new QTreeWidgetItem(item, {QString::fromStdString(symbol->name)});
        variable->setIcon(0, kit::icon(Icon::Variable));
        variable->setData(0, Kind, "variable");
        variable->setData(0, File, file);
        variable->setData(0, Offset, symbol->declaration.begin);
        variable->setData(0, Name, QString::fromStdString(symbol->path));
        variable->setToolTip(0, QString::fromStdString(symbol->comment));
    }
}

std::vector<const sema::Symbol*> ProjectTree::variablesIn(const analysis::OutlineItem& unit, const QString& file) const {
    std::vector<const sema::Symbol*> out;
    const auto& model = *m_workspace.model();
    const auto id = model.fileOf(file.toStdString());
    if (!id) return out;
    for (const sema::Symbol& symbol : model.checked().analysis->symbols) {
        const SourceRange& place = symbol.declaration;
        if (symbol.kind != SymbolKind::Variable || symbol.isConstant || !place.file.isValid() || place.file != *id || symbol.path.empty()) continue;
        if (place.begin >= unit.range.begin && place.begin < unit.range.end && (symbol.owner.empty() || foldCase(symbol.owner) == foldCase(unit.name))) out.push_back(&symbol);
    }
    return out;
}

void ProjectTree::reload() {
    if (!m_workspace.isOpen() || !m_workspace.model()) {
        m_tree->clear();
        m_shape.clear();
        return;
    }
    const auto& model = *m_workspace.model();
    struct Part {
        QString file;
        analysis::OutlineItem item;
    };
    std::map<QString, std::vector<Part>> parts; // by group key
    QString shape;
    for (const QString& file : m_workspace.files()) {
        if (m_workspace.isTestFile(file)) continue;
        const auto id = model.fileOf(file.toStdString());
        if (!id) continue;
        const auto place = [&](auto&& self, const std::vector<analysis::OutlineItem>& items) -> void {
            for (const analysis::OutlineItem& item : items) {
                const QString key = item.isSimulation                           ? "simulation"
                                    : item.kind == SymbolKind::Program          ? "programs"
                                    : item.kind == SymbolKind::FunctionBlock || item.kind == SymbolKind::Interface ? "blocks"
                                    : item.kind == SymbolKind::Function         ? "functions"
                                    : item.kind == SymbolKind::Type             ? "types"
                                    : item.kind == SymbolKind::GlobalList       ? "globals"
                                    : item.kind == SymbolKind::Task             ? "tasks"
                                                                                : "";
                if (item.kind == SymbolKind::Namespace) self(self, item.children);
                if (key.isEmpty()) continue;
                parts[key].push_back({file, item});
                shape += key + file + QString::fromStdString(item.name) + QString::number(item.nameRange.begin) + QString::number(item.children.size());
                if (key == "programs" || key == "globals")
                    for (const sema::Symbol* symbol : variablesIn(item, file)) shape += QString::fromStdString(symbol->path);
            }
        };
        place(place, model.outline(*id));
    }
    const projects::Project& project = m_workspace.project();
    for (const auto* list : {&project.panels, &project.traces, &project.libraries})
        for (const std::string& name : *list) shape += QString::fromStdString(name);
    shape += m_workspace.files().join('|') + m_workspace.folder();
    if (shape == m_shape) return;
    m_shape = shape;

    m_tree->clear();
    const auto fill = [&](const QString& title, Icon icon, const QString& key) {
        QTreeWidgetItem* parent = group(title, static_cast<int>(icon), key);
        for (const Part& part : parts[key]) addUnit(parent, part.item, part.file);
        return parent;
    };
    fill(tr("Programs"), Icon::Program, "programs");
    fill(tr("Blocks"), Icon::Block, "blocks");
    fill(tr("Functions"), Icon::Function, "functions");
    fill(tr("Types"), Icon::Structure, "types");
    fill(tr("Globals"), Icon::Globals, "globals");
    fill(tr("Tasks"), Icon::Task, "tasks");
    fill(tr("Simulation"), Icon::Simulation, "simulation");
    const auto names = [&](QTreeWidgetItem* parent, const std::vector<std::string>& list, const QString& kind, Icon icon, const QString& ending) {
        for (const std::string& name : list) {
            QString shown = QString::fromStdString(name);
            if (shown.endsWith(ending)) shown.chop(ending.size());
            auto* item = new QTreeWidgetItem(parent, {shown});
            item->setIcon(0, kit::icon(icon));
            item->setData(0, Kind, kind);
            item->setData(0, Name, shown);
        }
    };
    names(group(tr("Panels"), static_cast<int>(Icon::Panel), "panels"), project.panels, "panel", Icon::Panel, ".panel.json");
    auto* texts = new QTreeWidgetItem(m_tree, {tr("Texts")});
    texts->setIcon(0, kit::icon(Icon::Texts));
    texts->setData(0, Kind, "texts");
    auto* alarms = new QTreeWidgetItem(m_tree, {tr("Alarms")});
    alarms->setIcon(0, kit::icon(Icon::Alarm));
    alarms->setData(0, Kind, "alarms");
    names(group(tr("Traces"), static_cast<int>(Icon::Trace), "traces"), project.traces, "trace", Icon::Trace, ".trace.json");
    QTreeWidgetItem* tests = group(tr("Tests"), static_cast<int>(Icon::Test), "tests");
    for (const QString& file : m_workspace.files()) {
        if (!m_workspace.isTestFile(file)) continue;
        auto* item = new QTreeWidgetItem(tests, {QFileInfo(file).fileName()});
        item->setIcon(0, kit::icon(Icon::Test));
        item->setData(0, Kind, "unit");
        item->setData(0, File, file);
        item->setData(0, Offset, 0u);
        item->setData(0, Name, file);
    }
    names(group(tr("Libraries"), static_cast<int>(Icon::Library), "libraries"), project.libraries, "library", Icon::Library, "");
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = m_tree->topLevelItem(i);
        if (!m_collapsed.contains(item->data(0, Name).toString())) item->setExpanded(true);
        if (item->childCount() == 0 && item->data(0, Kind).toString().startsWith("group:")) item->setForeground(0, kit::colors().muted);
    }
    filter(m_filter->text());
}

void ProjectTree::activate(QTreeWidgetItem* item) {
    const QString kind = item->data(0, Kind).toString();
    if (kind == "unit" || kind == "variable") emit placeRequested(item->data(0, File).toString(), item->data(0, Offset).toUInt());
    else if (kind == "chart") emit chartRequested(item->data(0, File).toString(), item->data(0, Name).toString());
    else if (kind == "panel") emit panelRequested(item->data(0, Name).toString());
    else if (kind == "trace") emit traceRequested(item->data(0, Name).toString());
    else if (kind == "texts") emit textsRequested();
    else if (kind == "alarms") emit alarmsRequested();
    else if (kind == "library") emit librariesRequested();
}

void ProjectTree::showMenu(const QPoint& position) {
    QTreeWidgetItem* item = m_tree->itemAt(position);
    QMenu menu(this);
    connect(menu.addAction(kit::icon(Icon::New), tr("New…")), &QAction::triggered, this, &ProjectTree::newUnitRequested);
    if (item && item->data(0, Kind).toString() == "unit") {
        const QString file = item->data(0, File).toString();
        const uint32_t offset = item->data(0, Offset).toUInt(), end = item->data(0, EndOffset).toUInt();
        connect(menu.addAction(kit::icon(Icon::Open), tr("Open")), &QAction::triggered, this, [this, file, offset] { emit placeRequested(file, offset); });
        connect(menu.addAction(kit::icon(Icon::Rename), tr("Rename…")), &QAction::triggered, this, [this, file, offset] { emit renameRequested(file, offset); });
        const QString name = item->text(0);
        connect(menu.addAction(kit::icon(Icon::Delete), tr("Delete…")), &QAction::triggered, this, [this, file, offset, end, name] { emit deleteRequested(file, offset, end, name); });
    }
    connect(menu.addAction(kit::icon(Icon::Library), tr("Libraries…")), &QAction::triggered, this, &ProjectTree::librariesRequested);
    connect(menu.addAction(kit::icon(Icon::Test), tr("Run Tests")), &QAction::triggered, this, &ProjectTree::testsRequested);
    menu.exec(m_tree->viewport()->mapToGlobal(position));
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
