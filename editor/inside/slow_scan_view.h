// The slow scan: one recorded scan walked through statement by statement, forwards and backwards, with the call path
// and the values as they were at that moment; the controller goes on meanwhile. Owned by its dock; GUI thread.
#pragma once
#include "editor/inside/inside_desk.h"
#include "runtime/inside/slow_scan.h"

#include <QWidget>

class QAction;
class QLabel;
class QTreeWidget;

namespace plc::editor {

class SlowScanView : public QWidget {
    Q_OBJECT
public:
    SlowScanView(InsideDesk& desk, RunControl& control, QWidget* parent = nullptr);

    /// The scan that is shown, or the newest, from its first statement on; with `back` from its end, one step back.
    void open(std::optional<history::Position> at = {}, std::optional<debug::Step> back = {});
    void close();
    [[nodiscard]] bool isOpen() const { return m_scan != nullptr; }
    /// Null: none is walked through.
    [[nodiscard]] const inside::SlowScan* scan() const { return m_scan.get(); }
    [[nodiscard]] std::shared_ptr<const inside::Look> look() const { return m_look; }
    void step(debug::Step how);
    void stepBack(debug::Step how);
    void goOn();            // to the next breakpoint, else to the end
    void reverseContinue(); // to the one before, else to the beginning
    /// To the next time a statement on the line runs.
    void goToLine(const QString& file, int line);
    [[nodiscard]] QTreeWidget& frames() { return *m_frames; }
    [[nodiscard]] QTreeWidget& values() { return *m_values; }

signals:
    /// It stands elsewhere, or is open no more.
    void moved();
    void placeRequested(const QString& file, uint32_t offset, uint32_t length);

private:
    void follow();
    void show();
    void showValues();
    void takeBreakpoints();

    InsideDesk& m_desk;
    RunControl& m_control;
    std::shared_ptr<const inside::Look> m_look;
    std::unique_ptr<inside::SlowScan> m_scan;
    std::optional<history::Position> m_asked;
    unsigned m_number = 0;
    QLabel* m_state;
    QTreeWidget *m_frames, *m_values;
    QList<QAction*> m_moves;
};

} // namespace plc::editor
