// The themes of the project: made, renamed, coloured and deleted, beside a panel that shows the one at hand. With undo;
// written when the dialog is accepted. Owned by who asks; the context must outlive it. Main thread.
#pragma once
#include "editor/kit/inputs/property_grid.h"
#include "hmi/designer/context/design_context.h"
#include "hmi/view/panel_view.h"

#include <QDialog>
#include <QUndoStack>

class QAction;
class QComboBox;
class QLabel;

namespace plc::kit {
class Complaint;
}

namespace plc::hmi {

class ThemeDialog final : public QDialog {
    Q_OBJECT
public:
    /// `panel` is shown, or the start panel. Begins with that theme, or the panel's; else with the project's first.
    ThemeDialog(DesignContext& context, const QString& panel, const QString& theme, QWidget* parent = nullptr);

    QUndoStack& undoStack() { return m_undo; }
    QComboBox& choice() { return *m_choice; }
    kit::PropertyGrid& grid() { return *m_grid; }
    PanelView& preview() { return *m_preview; }
    QString complaint() const;
    /// What cannot be told apart well enough, in words; empty: everything can.
    QString weaknesses() const;
    /// The themes that the project would have now.
    QStringList names() const;

    /// Each returns what is wrong with the name, or "".
    QString add(const QString& name);
    QString rename(const QString& name);
    void removeShown();

    void accept() override;
    void reject() override;

private:
    struct Edited {
        QString origin; // its name on disk; empty: it is new
        PanelTheme theme;
    };
    using Themes = std::map<QString, Edited>;
    struct State {
        Themes themes;
        QString shown;
    };
    void makeBar();
    void askForName(const QString& title, const QString& present, QString (ThemeDialog::*take)(const QString&));
    QString whyNot(const QString& name) const;
    void change(const QString& title, State after);
    void changeTheme(const QString& title, const PanelTheme& theme);
    /// The theme with one row of the grid changed.
    PanelTheme with(const QString& id, const QVariant& value) const;
    void showState(State state);
    void showInPreview(const PanelTheme& theme);
    const PanelTheme& shown() const;
    void takeFromDisk();
    Result<void> write();

    DesignContext& m_context;
    State m_state;
    std::map<QString, PanelTheme> m_onDisk;
    QUndoStack m_undo;
    QComboBox* m_choice;
    kit::PropertyGrid* m_grid;
    PanelView* m_preview;
    QLabel* m_weak;
    kit::Complaint* m_complaint;
    QAction *m_rename = nullptr, *m_remove = nullptr;
    bool m_isWriting = false;
};

} // namespace plc::hmi
