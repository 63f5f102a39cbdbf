// The list of choices in a cell: it opens with the click that makes it, shows every choice whole, and says when it was
// closed, with or without a choice. Owned by the view that it edits for; GUI thread.
#pragma once

#include <QComboBox>

namespace plc::kit {

class ChoiceBox final : public QComboBox {
    Q_OBJECT
public:
    explicit ChoiceBox(QWidget* parent);
    /// Opens the list; while a mouse button is down, as if that press had been on this box.
    void open();
    void showPopup() override;
    void hidePopup() override;

signals:
    /// After `activated`, if there was a choice.
    void closed();
};

} // namespace plc::kit
