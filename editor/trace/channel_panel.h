// The list of a trace's charts and channels, an entry to add one, and the properties of what is selected. It edits
// nothing itself: it asks for a changed set-up. Owned by the trace view; GUI thread.
#pragma once

#include "editor/kit/inputs/expression_edit.h"
#include "editor/trace/curves/trace_plot.h"

#include <QWidget>

class QTreeWidget;
class QTreeWidgetItem;

namespace plc::kit {
class PropertyGrid;
}

namespace plc::trace {

class ChannelPanel : public QWidget {
    Q_OBJECT
public:
    explicit ChannelPanel(QWidget* parent = nullptr);

    void showSetup(const TraceSetup& setup, const plot::PlotModel& model);
    /// Values beside the names: at cursor A when there is one, else the newest.
    void showValues(const plot::PlotModel& model);
    void setCompletionSource(kit::CompletionSource source);
    void setCheck(kit::TextCheck check);
    void setPicker(std::function<std::optional<QString>(const QString&)> picker);
    kit::ExpressionEdit* entry() const { return m_entry; }
    QTreeWidget* list() const { return m_list; }
    kit::PropertyGrid* properties() const { return m_grid; }
    void selectChannel(int channel);
    /// -1: a chart or nothing is selected.
    int selectedChannel() const;
    int selectedChart() const;

signals:
    /// `change` makes the new set-up from the present one; `text` names the step for undo.
    void changeRequested(const QString& text, const std::function<void(plc::trace::TraceSetup&)>& change);
    void channelWanted(const QString& expression, int chart);
    void channelSelected(int channel);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void rebuild();
    void shareWidth();
    void showProperties();
    void describeChannel(int channel);
    void describeChart(int chart);
    void describeTrace();
    void commit(const QString& id, const QVariant& value);
    void commitChannel(int channel, const QString& id, const QVariant& value);
    void commitChart(int chart, const QString& id, const QVariant& value);
    void commitTrace(const QString& id, const QVariant& value);
    void removeSelected();
    void dropOn(QTreeWidgetItem* target, bool below, const QStringList& paths);

    TraceSetup m_setup;
    kit::ExpressionEdit* m_entry = nullptr;
    QTreeWidget* m_list = nullptr;
    kit::PropertyGrid* m_grid = nullptr;
    std::pair<int, int> m_shown{-1, -1}; // channel and chart in the grid
    bool m_filling = false,
         m_isTicked = false; // ticked: the list is telling us of a change and must not be rebuilt yet
};

} // namespace plc::trace

Q_DECLARE_METATYPE(std::function<void(plc::trace::TraceSetup&)>)
