// "Show as ST" and "Show as IL": a unit in both languages side by side; the other one can be copied or take the unit's
// place, as one step of the file's undo. Lives as long as it is shown; GUI thread.
#pragma once
#include "editor/workspace/workspace.h"
#include "projects/analysis/conversion.h"

#include <QDialog>

namespace plc::app {

class ConversionDialog : public QDialog {
    Q_OBJECT
public:
    ConversionDialog(const std::string& before, const std::string& after, const analysis::Conversion& conversion,
                     analysis::TextLanguage to, QWidget* parent);
    /// The unit's text as it would become.
    [[nodiscard]] const std::string& result() const { return m_result; }

signals:
    void replaceRequested();

private:
    std::string m_result;
};

} // namespace plc::app
