// Which docks are shown for which work: editing, debugging, drawing panels; and the documents alone. What the user
// moves in one of them is there again when he comes back to it. Owned by the main window; GUI thread.
#pragma once
#include <QByteArray>
#include <QMap>
#include <QObject>
#include <QStringList>

#include <optional>

class QMainWindow;

namespace plc::app {

enum class Perspective : uint8_t { Editing, Debugging, PanelDesign };

class Perspectives : public QObject {
    Q_OBJECT
public:
    explicit Perspectives(QMainWindow& window);
    void show(Perspective wanted);
    /// Only the documents; again: as it was.
    void toggleMaximised();
    [[nodiscard]] bool isMaximised() const { return !m_beforeMaximised.isEmpty(); }
    void leaveMaximised();
    /// The names of the docks that belong to the work, in order; the first of each area is in front.
    [[nodiscard]] static QStringList docksOf(Perspective perspective);

private:
    QMainWindow& m_window;
    std::optional<Perspective> m_shown;
    QMap<int, QByteArray> m_left; // how each was when it was left
    QByteArray m_beforeMaximised;
};

} // namespace plc::app
