// Choosing a variable: a tree that unfolds structures, and a search over all paths. What there is comes from a
// provider. Owned by its Qt parent; the provider must outlive it. GUI thread.
#pragma once

#include "editor/kit/icons.h"

#include <QDialog>
#include <QWidget>

#include <optional>
#include <vector>

class QLineEdit;
class QMimeData;
class QStackedWidget;
class QTreeView;
class QTreeWidget;
class QTreeWidgetItem;

namespace plc::kit {

/// Dragged variables: one path a line.
inline const QString VariableMime = QStringLiteral("application/x-stepwise-variables");
QMimeData* makeVariableMime(const QStringList& paths);
/// Paths of a drag; of plain text, its lines.
QStringList variablesOf(const QMimeData* mime);

struct VariableNode {
    QString name; // shown in the tree
    QString path; // the whole path
    QString type;
    QString comment;
    Icon icon = Icon::Variable;
    bool hasChildren = false;
    bool isSelectable = true; // a group of globals is not
};

class VariableProvider {
public:
    virtual ~VariableProvider() = default;
    /// Members below a path; of the empty path, the roots.
    virtual std::vector<VariableNode> children(const QString& path) const = 0;
    /// Nodes whose path matches the typed text, best first.
    virtual std::vector<VariableNode> search(const QString& text, int limit) const = 0;
};

class VariablePicker : public QWidget {
    Q_OBJECT
public:
    explicit VariablePicker(const VariableProvider& provider, QWidget* parent = nullptr);

    QStringList selectedPaths() const;
    void setFilter(const QString& text);
    /// Reads the provider again, keeping what is unfolded.
    void reload();
    bool selectPath(const QString& path);

signals:
    void picked(const QString& path);
    void selectionChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addChildren(QTreeWidgetItem* parent, const QString& path);
    void unfold(QTreeWidgetItem* item);
    void showResults(const QString& text);
    QTreeWidget* present() const;

    const VariableProvider& m_provider;
    QLineEdit* m_search = nullptr;
    QStackedWidget* m_pages = nullptr;
    QTreeWidget* m_tree = nullptr;
    QTreeWidget* m_results = nullptr;
};

/// Asks for one variable in a dialog; nothing when it was cancelled.
std::optional<QString> pickVariable(const VariableProvider& provider, const QString& current, QWidget* parent);

} // namespace plc::kit
