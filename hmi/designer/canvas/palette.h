// The elements to draw with, by category, with search; dragged onto the canvas or put in by a double click.
// Owned by its Qt parent; main thread.
#pragma once
#include "hmi/view/scene/ready_faceplates.h"

#include <QIcon>
#include <QTreeWidget>

class QLineEdit;

namespace plc::hmi {

/// Dragged elements: a JSON list of their fields.
inline const QString kElementMime = QStringLiteral("application/x-stepwise-elements");

class Palette final : public QWidget {
    Q_OBJECT
public:
    explicit Palette(QWidget* parent = nullptr);
    /// The project's own faceplates, above the ready ones.
    void setFaceplates(const std::vector<NamedPanel>& panels);
    void setFilter(const QString& text);
    QStringList shownTitles() const;
    QTreeWidget& tree() { return *m_tree; }

signals:
    /// A double click or Enter, in the search too: there it is the one whose title fits best.
    void elementChosen(const plc::hmi::Json& fields);

private:
    void choose(const QTreeWidgetItem* item);
    QTreeWidgetItem* addGroup(const QString& title);
    void addItem(QTreeWidgetItem* group, const QString& title, const QString& words, const Json& fields,
                 const QIcon& icon);
    QLineEdit* m_search;
    QTreeWidget* m_tree;
    QTreeWidgetItem* m_faceplates = nullptr;
};

/// A small picture of an element with its defaults.
QIcon elementIcon(const Json& fields, int side = 32);
/// Fields of a new element of the kind; symbols bring their symbol.
/// Fields of a new faceplate element as large as its panel.
Json newFaceplateFields(const NamedPanel& panel);
QIcon faceplateIcon(const NamedPanel& panel, const std::vector<NamedPanel>& panels, int side = 32);
Json newElementFields(ElementKind kind, const QString& symbol = {});

} // namespace plc::hmi
