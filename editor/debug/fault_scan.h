// The scan in which the controller has faulted, and the values its frames had then. Asked at every refresh while a
// plant may go on for hours, so what was found is kept; it is let go with the session. Owned by RunControl; GUI thread.
#pragma once
#include "runtime/controller/controller.h"
#include "runtime/history/history.h"
#include "runtime/types/value.h"

#include <QObject>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace plc::inside {
struct Rerun;
}
namespace plc::session {
class Session;
}

namespace plc::editor {

class RunControl;

class FaultScan : public QObject {
    Q_OBJECT
public:
    explicit FaultScan(RunControl& control);
    ~FaultScan() override;

    /// Where the scan of the present fault is in the recording; none without a fault, or where it was not recorded.
    [[nodiscard]] std::optional<history::Position> position();
    /// The scan that is looked at is that of the present fault.
    [[nodiscard]] bool isShown();
    /// Name and value of the variables of a frame of the present fault. Optimised code keeps locals in registers, so
    /// the scan is made again by the quick code; where that does not lead to the same fault, what the session has kept.
    [[nodiscard]] std::vector<std::pair<std::string, types::Value>> variables(size_t frame);

private:
    struct Repeated;

    void forget();

    const RunControl& m_control;
    std::optional<history::Position> m_last;
    std::unique_ptr<Repeated> m_repeated; // the scan made again; null: not asked for yet
};

} // namespace plc::editor
