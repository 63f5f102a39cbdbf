// The editor of a table's cell in which a name, or several with commas between them, is chosen from a list or typed.
// Owned by its table; GUI thread.
#pragma once
#include <QStringList>
#include <QStyledItemDelegate>

#include <functional>

namespace plc::hmi {

class ChoiceCell final : public QStyledItemDelegate {
    Q_OBJECT
public:
    enum class Takes { One, Several };
    /// `choices` is asked each time a cell is opened.
    ChoiceCell(std::function<QStringList()> choices, Takes takes, QObject* parent);

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

private:
    std::function<QStringList()> m_choices;
    Takes m_takes;
};

} // namespace plc::hmi
