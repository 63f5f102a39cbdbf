// A message that is wider than its room in the status line, shown whole above the line for as long as the line has it.
// Owned by the window; a click closes it. GUI thread.
#pragma once
#include <QLabel>

class QStatusBar;

namespace plc::app {

class LongMessage final : public QLabel {
public:
    LongMessage(QStatusBar& bar, QWidget& window);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    void showWhole(const QString& text);
    void place();
    [[nodiscard]] int room() const; // of the line, beside what stands in it

    QStatusBar& m_bar;
    QWidget& m_window;
};

} // namespace plc::app
