#include "hmi/designer/editors/choice_cell.h"

#include "editor/kit/word_list.h"

#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>

namespace plc::hmi {

namespace {
constexpr const char* kTyped = "typed"; // the text before something was chosen, which replaces it

/// Choosing adds a name or takes it away, which the arrow keys must not do in passing: they open the list.
class ListCombo final : public QComboBox {
public:
    using QComboBox::QComboBox;

protected:
    void keyPressEvent(QKeyEvent* event) override {
        if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down) return showPopup();
        QComboBox::keyPressEvent(event);
    }
    void wheelEvent(QWheelEvent*) override {}
};

/// What choosing a name does is written before it. (It also keeps the items apart from what is typed: when editing
/// ends, a combo box chooses the item that the text is equal to.)
void offer(QComboBox& combo, const QString& list) {
    const QStringList chosen = kit::wordsOf(list);
    for (int i = 0; i < combo.count(); ++i) {
        const QString name = combo.itemData(i).toString();
        const bool isChosen = chosen.contains(name, Qt::CaseInsensitive);
        combo.setItemText(i, (isChosen ? QStringLiteral("\u2212 ") : QStringLiteral("+ ")) + name);
    }
    combo.setProperty(kTyped, list);
    combo.setEditText(list);
}

} // namespace

ChoiceCell::ChoiceCell(std::function<QStringList()> choices, Takes takes, QObject* parent)
    : QStyledItemDelegate(parent), m_choices(std::move(choices)), m_takes(takes) {}

QWidget* ChoiceCell::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const {
    auto* combo = m_takes == Takes::One ? new QComboBox(parent) : new ListCombo(parent);
    combo->setEditable(true);
    combo->setInsertPolicy(QComboBox::NoInsert);
    combo->setFrame(false);
    combo->lineEdit()->setAccessibleName(index.model()->headerData(index.column(), Qt::Horizontal).toString());
    for (const QString& name : m_choices()) combo->addItem(name, name);
    if (m_takes == Takes::One) return combo;
    combo->setCompleter(nullptr); // it would complete the whole list of names, not the last of them
    connect(combo->lineEdit(), &QLineEdit::textEdited, combo,
            [combo](const QString& text) { combo->setProperty(kTyped, text); });
    connect(combo, &QComboBox::activated, combo, [combo](int row) {
        offer(*combo, kit::withToggled(combo->property(kTyped).toString(), combo->itemData(row).toString()));
    });
    return combo;
}

void ChoiceCell::setEditorData(QWidget* editor, const QModelIndex& index) const {
    auto* combo = qobject_cast<QComboBox*>(editor);
    const QString text = index.data(Qt::EditRole).toString();
    if (m_takes == Takes::Several) {
        combo->setCurrentIndex(-1);
        offer(*combo, text);
    } else {
        combo->setCurrentIndex(combo->findText(text, Qt::MatchFixedString));
        combo->setEditText(text);
    }
    combo->lineEdit()->selectAll();
}

void ChoiceCell::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
    model->setData(index, qobject_cast<QComboBox*>(editor)->currentText());
}

} // namespace plc::hmi
