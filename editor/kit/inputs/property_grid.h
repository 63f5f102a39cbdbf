// A property grid made from descriptors: it shows values, offers the fitting editor, and reports edits; it changes no
// model. While a value is being spun or picked it is `previewed`; once the user is done it is `committed`, exactly
// once: one undo step. Owned by its Qt parent; GUI thread.
#pragma once

#include "editor/kit/inputs/expression_edit.h"

#include <QTreeWidget>
#include <QVariant>

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace plc::kit {

enum class PropertyKind {
    Text,
    LongText, // several lines, edited in a small window
    Integer,
    Number,
    Bool,
    Enumeration, // one of `choices`
    Color,       // a QColor, or an expression's colour; an invalid colour is "none"
    Expression,  // an ST expression with completion
    File,
    Action // a text and a button; pressing it emits actionRequested
};

struct PropertyChoice {
    QVariant value;
    QString label;
    std::optional<Icon> icon;
    QColor color = {}; // shown as a swatch before the label
    bool operator==(const PropertyChoice&) const = default;
};

struct PropertyDescriptor {
    QString id;
    QString group;
    QString label;
    QString toolTip;
    PropertyKind kind = PropertyKind::Text;
    double minimum = -1e12, maximum = 1e12, step = 1;
    int decimals = 3;
    QString suffix;
    std::vector<PropertyChoice> choices;
    QStringList words; // of a text: completed while it is typed
    QString fileFilter;
    QVariant defaultValue; // shown in the plain face; valid: "Reset" is offered
    QString placeholder;
    bool isReadOnly = false;
    bool canBeNone = true; // a colour
    bool operator==(const PropertyDescriptor&) const = default;
};

class PropertyGrid : public QTreeWidget {
    Q_OBJECT
public:
    explicit PropertyGrid(QWidget* parent = nullptr);

    /// The same descriptors again leave rows and an open editor as they are.
    void setDescriptors(std::vector<PropertyDescriptor> descriptors);
    const PropertyDescriptor* descriptor(const QString& id) const;
    void setValue(const QString& id, const QVariant& value);
    void setValues(const std::map<QString, QVariant>& values);
    QVariant value(const QString& id) const;
    /// Several things are selected and differ here: shown as "various".
    void setVarious(const QString& id);
    bool isVarious(const QString& id) const;
    /// Shows rows whose label, id or value contains the text.
    void setFilter(const QString& text);

    void setCompletionSource(CompletionSource source) { m_completions = std::move(source); }
    void setCheck(std::function<QString(const QString& id, const QString& text)> check) { m_check = std::move(check); }
    /// Called by the "…" button beside an expression.
    void setPicker(std::function<std::optional<QString>(const QString& current)> picker) {
        m_picker = std::move(picker);
    }
    /// Files are shown relative to this folder.
    void setBaseFolder(const QString& folder) { m_folder = folder; }

    void editProperty(const QString& id);
    /// Commits what is being typed. For an owner that shows another thing from now on: what was typed belongs to the
    /// one before.
    void endEditing();
    QTreeWidgetItem* row(const QString& id) const;
    void keyboardSearch(const QString& text) override;

signals:
    void previewed(const QString& id, const QVariant& value);
    /// The row was left as it was before the previews.
    void previewWithdrawn(const QString& id);
    void committed(const QString& id, const QVariant& value);
    void resetRequested(const QString& id);
    void actionRequested(const QString& id);

protected:
    void drawRow(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    QModelIndex moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    friend class PropertyDelegate;
    struct Entry {
        PropertyDescriptor descriptor;
        QVariant value;
        bool isVarious = false;
        QTreeWidgetItem* item = nullptr;
    };
    Entry* entry(const QString& id);
    const Entry* entry(const QString& id) const;
    Entry* entryOf(const QTreeWidgetItem* item);
    void drawArrow(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& heading) const;
    void showValue(Entry& entry);
    /// Names are read whole, as long as they leave room for the values and nobody has moved the divider.
    void fitNames();
    /// The expression under a variable that is dragged; null elsewhere.
    const Entry* entryUnder(const QDropEvent& event);
    void commit(const QString& id, const QVariant& value);

    std::vector<Entry> m_entries;
    std::map<QString, bool> m_folded;
    bool m_isFitting = false;
    bool m_namesAreSized = false; // by hand
    CompletionSource m_completions;
    std::function<QString(const QString&, const QString&)> m_check;
    std::function<std::optional<QString>(const QString&)> m_picker;
    QString m_folder;
};

/// Text of a value as the grid shows it.
QString propertyText(const PropertyDescriptor& descriptor, const QVariant& value);

} // namespace plc::kit
