// Where devices meet the scan (D8, D16): right before each scan they put bytes into the image, and the journal keeps
// what they put like everything else that comes from outside. Scan thread only; nothing in here waits.
#pragma once
#include "runtime/base/message.h"
#include "runtime/image/layout.h"

#include <cstddef>
#include <span>
#include <string>

namespace plc::controller {

class Controller;

/// What a ScanEdge may do with the image.
class EdgeWriter {
public:
    /// The bytes of one variable as they lie in the image (a bit: one byte, 0 or 1). A variable that has them already,
    /// or is forced, is left alone.
    virtual void put(const image::Place& place, std::span<const std::byte> bytes, const std::string& origin) = 0;
    /// The PLC stops with this fault before the scan; nothing while it does not run.
    virtual void fault(Message why) = 0;
    /// Whether the programs of the PLC run in the scan to come (the plant may run alone).
    [[nodiscard]] virtual bool plcRuns() const = 0;

protected:
    ~EdgeWriter() = default;
};

class ScanEdge {
public:
    virtual ~ScanEdge() = default;
    virtual void beforeScan(EdgeWriter& writer) = 0;
};

/// One edge at a time, which must outlive the controller; null: none.
void setScanEdge(Controller& controller, ScanEdge* edge);

} // namespace plc::controller
