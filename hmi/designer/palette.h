// The elements to draw with, by category, with search; dragged onto the canvas or put in by a double click.
// Owned by its Qt parent; main thread.
#pragma once
#include "hmi/model/panel.h"

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
    void setFilter(const QString& text);
    QStringList shownTitles() const;
    QTreeWidget& tree() { return *m_tree; }

signals:
    /// A double click or Enter.
    void elementChosen(const plc::hmi::Json& fields);

private:
    QLineEdit* m_search;
    QTreeWidget* m_tree;
};

/// A small picture of an element with its defaults.
QIcon elementIcon(const Json& fields, int side = 32);
/// Fields of a new element of the kind; symbols bring their symbol.
Json newElementFields(ElementKind kind, const QString& symbol = {});

} // namespace plc::hmi
