// Which libraries a project uses. Owned by who shows it; GUI thread.
#pragma once
#include <QDialog>

#include <string>
#include <utility>
#include <vector>

class QCheckBox;

namespace plc::app {

class LibrariesDialog : public QDialog {
    Q_OBJECT
public:
    LibrariesDialog(const std::vector<std::string>& used, QWidget* parent);
    [[nodiscard]] std::vector<std::string> chosen() const;

private:
    std::vector<std::pair<std::string, QCheckBox*>> m_boxes;
};

} // namespace plc::app
