// Asks for the new name of something and shows every place that changes with it, in the code and in panels. GUI thread.
#pragma once
#include <QDialog>

#include <vector>

class QLineEdit;
class QTreeWidget;

namespace plc::app {

class RenameDialog : public QDialog {
    Q_OBJECT
public:
    struct Place {
        QString where, text; // "src/main.st:12", the line
    };
    RenameDialog(const QString& old, const std::vector<Place>& places, QWidget* parent);
    [[nodiscard]] QString name() const;
    [[nodiscard]] QTreeWidget& places() { return *m_places; }

private:
    QLineEdit* m_name;
    QTreeWidget* m_places;
};

} // namespace plc::app
