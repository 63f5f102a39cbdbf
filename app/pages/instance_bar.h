// Above the text of a block: whose values stand beside it, and a list of the instances to choose from. Owned by the
// page; GUI thread.
#pragma once
#include <QWidget>

class QComboBox;
class QLabel;

namespace plc::app {

class InstanceBar : public QWidget {
    Q_OBJECT
public:
    explicit InstanceBar(QWidget* parent = nullptr);
    /// Hidden where there are none: programs, functions, types.
    void show(const QString& block, const QStringList& instances, const QString& chosen);
    [[nodiscard]] QString shownInstance() const;

signals:
    void instanceChosen(const QString& block, const QString& instance);

private:
    QString m_block;
    QStringList m_instances;
    QLabel* m_label;
    QComboBox* m_choice;
};

} // namespace plc::app
