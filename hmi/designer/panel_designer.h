// The designer of one panel: palette, canvas, property sheet, outline, findings, live preview, and its actions.
// Owned by its Qt parent (a tab of the studio); the context must outlive it. Main thread.
#pragma once
#include "hmi/designer/canvas/design_canvas.h"
#include "hmi/designer/sheet/property_sheet.h"

#include <QTimer>
#include <QWidget>

class QAction;
class QComboBox;
class QLabel;
class QMenu;
class QStackedWidget;
class QToolBar;
class QTreeWidget;

namespace plc::hmi {

class Outline;
class Palette;
class PanelPlayer;
class PanelVariables;

class PanelDesigner final : public QWidget {
    Q_OBJECT
public:
    PanelDesigner(DesignContext& context, const QString& panelName, QWidget* parent = nullptr);
    ~PanelDesigner() override;

    const QString& panelName() const { return m_name; }
    PanelDocument& document() { return m_document; }
    Selection& selection() { return m_selection; }
    DesignCanvas& canvas() { return *m_canvas; }
    PropertySheet& sheet() { return *m_sheet; }
    Palette& palette() { return *m_palette; }
    Outline& outline() { return *m_outline; }
    PanelPlayer* preview() { return m_player.get(); }
    const std::vector<Finding>& findings() const { return m_findings; }
    bool isModified() const { return !m_document.isClean(); }
    Result<void> save();
    /// The file changed on disk.
    void reload(const Panel& panel);
    /// Shows the panel on the running controller in the place of the canvas; edits go on.
    void setLive(bool live);
    bool isLive() const { return m_player != nullptr; }
    void checkNow();
    /// An action by its name: "align-left", "group", "duplicate-array", …
    QAction* action(const QString& name) const { return m_actions.value(name); }
    QList<QAction*> actions() const { return m_actions.values(); }

public slots:
    void cut();
    void copy();
    void paste(bool inPlace = false);
    void duplicate();
    void duplicateAsArray();
    void arrangeOverArray();
    void group();
    void ungroup();
    void layOut(const char* layout);
    void selectAll();
    /// Corrects what the finding of that number is about, as one undo step.
    void fixFinding(size_t index);
    void fixAll();

signals:
    /// To open the panel of a faceplate.
    void panelRequested(const QString& name);
    void refused(const QString& reason);
    void modifiedChanged(bool modified);
    void findingsChanged();

private:
    QWidget* makeSources();
    void makeActions();
    QAction* add(const QString& name, const QString& title, kit::Icon icon, const QKeySequence& shortcut,
                 const std::function<void()>& run);
    void addEdit(const QString& name, const QString& title, kit::Icon icon, const QKeySequence& shortcut,
                 const std::function<Edit()>& edit);
    QToolBar* makeToolBar();
    void showMenu(QPoint at);
    void showFindings();
    /// The texts without a key among what the findings are about get one.
    void moveToTexts(const std::vector<Finding>& findings);
    void showFindingMenu(QPoint at);
    void showInPreview();
    void updateActions();
    void sayRefusal(const QString& reason);
    /// The faceplate that is selected alone, or null.
    const Element* selectedFaceplate() const;

    DesignContext& m_context;
    QString m_name;
    PanelDocument m_document;
    Selection m_selection;
    QMap<QString, QAction*> m_actions;
    Palette* m_palette;
    std::unique_ptr<PanelVariables> m_bindable; // what the picker lists
    kit::VariablePicker* m_variables = nullptr;
    Json m_parametersListed; // by it
    DesignCanvas* m_canvas;
    PropertySheet* m_sheet;
    Outline* m_outline;
    QTreeWidget* m_findingList;
    QStackedWidget* m_pages;
    QLabel* m_where;
    std::unique_ptr<PanelPlayer> m_player;
    std::vector<Finding> m_findings;
    QTimer m_checkTimer;
    ArrayLayout m_arrayLayout;
};

} // namespace plc::hmi
