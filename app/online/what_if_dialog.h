// "What if?": which variables shall have had another value in the scan that is shown, before the controller goes on
// from there. Made by the main window for one question; modal; GUI thread.
#pragma once
#include "editor/debug/run_control.h"
#include "editor/kit/inputs/expression_edit.h"

#include <QDialog>

class QLabel;
class QTableWidget;

namespace plc::app {

class WhatIfDialog : public QDialog {
    Q_OBJECT
public:
    WhatIfDialog(const editor::RunControl& control, const QStringList& variables, kit::CompletionSource complete,
                 QWidget* parent = nullptr);
    /// Path and value as typed, of those that shall be otherwise.
    [[nodiscard]] std::vector<std::pair<QString, QString>> changes() const;
    void addVariable(const QString& path);
    [[nodiscard]] QTableWidget& table() { return *m_table; }
    void accept() override; // only when each value can be written

private:
    const editor::RunControl& m_control;
    kit::ExpressionEdit* m_input;
    QTableWidget* m_table;
    QLabel* m_problem;
};

} // namespace plc::app
