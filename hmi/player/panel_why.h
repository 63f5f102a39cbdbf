// Why a value of the panel is as it is, in the operator's language and with the panel's own names for variables, over
// the panel that plays: asked on a thread of its own, where no studio answers. Owned by the player; main thread. The
// recording must outlive it. Closed before the answer is there, it ends the search.
#pragma once
#include "editor/kit/ask_why.h"
#include "hmi/station/operator_names.h"
#include "runtime/history/history.h"

#include <QWidget>

#include <atomic>
#include <optional>
#include <thread>

class QLabel;
class QTreeWidget;

namespace plc::hmi {

class PanelWhy final : public QWidget {
    Q_OBJECT
public:
    PanelWhy(const history::History& history, kit::AskWhy question, const QString& expression,
             std::optional<history::Position> at, const QString& language, OperatorNames names, QWidget* parent);
    ~PanelWhy() override;

    [[nodiscard]] bool isAnswered() const { return m_isAnswered; }
    /// The answer, a line for each sentence.
    [[nodiscard]] QString text() const;

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Answer;
    void show(const Answer& answer);

    QString m_language;
    OperatorNames m_names;
    std::shared_ptr<std::atomic<bool>> m_isCancelled = std::make_shared<std::atomic<bool>>(false);
    QLabel* m_state;
    QTreeWidget* m_tree;
    bool m_isAnswered = false;
    std::thread m_thread;
};

} // namespace plc::hmi
