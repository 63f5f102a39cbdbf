// Asks for the new name of something and shows every place that changes with it, in the code and in panels. GUI thread.
#pragma once
#include <QDialog>

#include <functional>
#include <vector>

class QLineEdit;
class QTreeWidget;

namespace plc::kit {
class Complaint;
}
namespace plc::app {

class RenameDialog : public QDialog {
    Q_OBJECT
public:
    struct Place {
        QString where, text; // "src/main.st:12", the line
    };
    /// What is wrong with a name, or "". The dialog says it and stays open.
    using Check = std::function<QString(const QString& name)>;
    /// `note`: what else there is to know, or "".
    RenameDialog(const QString& old, const std::vector<Place>& places, const QString& note, Check check,
                 QWidget* parent);
    [[nodiscard]] QString name() const;
    [[nodiscard]] QTreeWidget& places() { return *m_places; }
    [[nodiscard]] QString complaint() const;
    void accept() override;

private:
    Check m_check;
    QString m_old;
    QLineEdit* m_name;
    QTreeWidget* m_places;
    kit::Complaint* m_complaint;
};

} // namespace plc::app
