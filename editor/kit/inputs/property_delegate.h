// Paints the value cells of a property grid and makes their editors. Owned by the grid; GUI thread.
#pragma once

#include <QPointer>
#include <QStyledItemDelegate>
#include <QVariant>

#include <optional>

namespace plc::kit {

class PropertyGrid;

class PropertyDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    static constexpr int IdRole = Qt::UserRole + 1; // of an item in the first column: the id of its property

    explicit PropertyDelegate(PropertyGrid& grid);

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    bool eventFilter(QObject* editor, QEvent* event) override;
    /// The editor that is open, if there is one, as by Enter.
    void finishOpen();

private:
    QWidget* makeTextEditor(QWidget* parent, const QString& id) const;
    std::optional<QVariant> valueOf(QWidget* editor, const QString& id) const;
    void finish(QWidget* editor) const;
    void commit(const QString& id, const std::optional<QVariant>& value) const;
    void takePreviewBack(const QWidget* editor, const QString& id) const;

    PropertyGrid& m_grid;
    mutable QPointer<QWidget> m_open; // the editor that was filled last
};

} // namespace plc::kit
