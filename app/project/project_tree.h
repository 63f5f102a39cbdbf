// The project as a tree made from the parsed files: programs, blocks, functions, types, globals, tasks, libraries,
// panels, texts, traces, tests, simulation. Owned by its dock; GUI thread.
#pragma once
#include "editor/kit/ask_why.h"
#include "editor/workspace/workspace.h"

#include <QTreeWidget>
#include <QWidget>

#include <functional>
#include <map>

class QLineEdit;
class QMenu;
class QToolButton;

namespace plc::app {

class ProjectTree : public QWidget {
    Q_OBJECT
public:
    explicit ProjectTree(editor::Workspace& workspace, QWidget* parent = nullptr);
    void reload();
    [[nodiscard]] QTreeWidget& tree() { return *m_tree; }

    /// Which block a path lies in, and its instance (two empty texts: in none); the instances of a block. Both of the
    /// program that is shown; without them the menu does not offer instances.
    using InstanceAt = std::function<std::pair<QString, QString>(const QString& path)>;
    using InstancesOf = std::function<std::vector<QString>(const QString& block)>;
    void setInstances(InstanceAt at, InstancesOf of);

    /// The path of the variable that has the focus; empty: none has.
    [[nodiscard]] QString focusedVariable() const;

signals:
    void placeRequested(const QString& file, uint32_t offset);
    void panelRequested(const QString& name);
    void traceRequested(const QString& name);
    void textsRequested();
    void alarmsRequested();
    void recipesRequested();
    void peopleRequested();
    void themesRequested();
    void devicesRequested();
    void testsRequested();
    void chartRequested(const QString& file, const QString& pou);
    /// Preset in the dialog: a template ("block") and a file; both may be empty.
    void newUnitRequested(const QString& kind, const QString& file);
    void newPanelRequested();
    void newTraceRequested();
    /// A file of the project: kind is "panel", "trace", "test" or "source".
    void renameFileRequested(const QString& kind, const QString& name);
    void deleteFileRequested(const QString& kind, const QString& name);
    void watchRequested(const QString& path);
    /// The block's text with the values of that instance.
    void instanceRequested(const QString& block, const QString& instance);
    void whyRequested(plc::kit::AskWhy question, const QString& path);
    void renameRequested(const QString& file, uint32_t offset);
    void deleteRequested(const QString& file, uint32_t begin, uint32_t end, const QString& name);
    void librariesRequested();

private:
    enum Role { Kind = Qt::UserRole, File, Offset, EndOffset, Name, Path, Note };
    struct Unit {
        QString file;
        analysis::OutlineItem item;
    };
    using Units = std::map<QString, std::vector<Unit>>; // by the key of their group
    [[nodiscard]] Units unitsByGroup() const;
    void gatherVariables();
    [[nodiscard]] QString shapeOf(const Units& units) const;
    void addUnits(const Units& units);
    void addFiles();
    void addDesigns();
    void addTests();
    void markChanged();
    void addLibraries();
    [[nodiscard]] bool isByFile() const;
    void addVariables(QTreeWidgetItem* parent, const std::string& owner, const QString& file);
    void rename(QTreeWidgetItem* item);
    void remove(QTreeWidgetItem* item);
    bool eventFilter(QObject* watched, QEvent* event) override;
    QTreeWidgetItem* group(const QString& title, int icon, const QString& key);
    void addUnit(QTreeWidgetItem* parent, const analysis::OutlineItem& unit, const QString& file);
    void activate(QTreeWidgetItem* item);
    void showMenu(const QPoint& position);
    void addInstances(QMenu& menu, const QTreeWidgetItem& item);
    void filter(const QString& text);

    editor::Workspace& m_workspace;
    QTreeWidget* m_tree = nullptr;
    QLineEdit* m_filter = nullptr;
    QToolButton* m_byFile = nullptr;
    InstanceAt m_instanceAt;
    InstancesOf m_instancesOf;
    QStringList m_collapsed;
    std::map<std::string, std::vector<const sema::Symbol*>> m_variables; // by folded owner, while the tree is made
    QString m_shape; // what the tree shows now; an equal new one is not rebuilt
};

} // namespace plc::app
