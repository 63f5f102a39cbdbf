// The properties of what is selected (or of the panel), made from the descriptors: one undo step per change, several
// elements at once, texts with their keys. Owned by its Qt parent; main thread.
#pragma once
#include "hmi/designer/context/panel_variables.h"
#include "hmi/designer/context/selection.h"
#include "hmi/designer/sheet/property_mapping.h"

#include <QWidget>

class QLabel;
class QLineEdit;

namespace plc::hmi {

class PropertySheet final : public QWidget {
    Q_OBJECT
public:
    PropertySheet(PanelDocument& document, Selection& selection, DesignContext& context, QWidget* parent = nullptr);
    void setPanelName(const QString& name) { m_panelName = name; }
    kit::PropertyGrid& grid() { return *m_grid; }
    /// Sets a property of everything selected, as an edit in the grid does.
    void commit(const QString& id, const QVariant& value);
    void editRecords(const QString& id);
    void refresh();

private:
    void showSelection();
    void rebuild();
    /// Changes with the rows: kinds of what is selected, and which properties say something.
    QString shapeNow() const;
    ElementIds targets() const;
    const ElementDescriptor& descriptor() const;
    std::vector<const PropertyDescriptor*> shared() const;
    const Json& valueOf(const ElementId& id, const PropertyDescriptor& property) const;
    std::vector<kit::PropertyDescriptor> rowsOf(const PropertyDescriptor& property) const;
    void storeTexts(const PropertyDescriptor& property, const QString& id, const QString& typed);
    void apply(const QString& id, const QVariant& value, int gesture);
    /// Completion and choice of the variables that a binding in this panel can name.
    void offerVariables(kit::PropertyGrid& grid) const;
    PanelDocument& m_document;
    Selection& m_selection;
    DesignContext& m_context;
    const PanelVariables m_variables;
    QString m_panelName;
    QLabel* m_title;
    QLineEdit* m_filter;
    kit::PropertyGrid* m_grid;
    ElementIds m_shown; // the empty id: the panel
    QString m_shape;    // what the rows were made for
    int m_gesture = 0;
    QString m_gestureId;
};

} // namespace plc::hmi
