// Builds the body of a PLCopen diagram from other tools' forms of ladders and function blocks: nodes with ids, wires
// between them. One use per body.
#pragma once
#include "projects/exchange/base/xml.h"

#include <string>
#include <vector>

namespace plc::exchange {

/// Marks of contacts, coils and pins.
struct PinMarks {
    bool isNegated = false, isSet = false, isReset = false, rises = false, falls = false;
};

/// What a connection comes from; no id: nothing.
struct Wire {
    std::string id, pin;
    [[nodiscard]] bool isConnected() const { return !id.empty(); }
};

struct BoxInput {
    std::string name;
    Wire wire;
    PinMarks marks;
};

class DiagramBuilder {
public:
    /// Adds an <LD> or <FBD> to the document.
    DiagramBuilder(pugi::xml_document& document, bool isLadder);

    void label(const std::string& name);
    void comment(const std::string& text);
    Wire rail();
    Wire operand(const std::string& text, const PinMarks& marks);
    /// A contact behind `before`, which may be nothing: then at the rail.
    Wire contact(const std::string& text, const PinMarks& marks, const Wire& before);
    /// Gives the wire of the output `main`.
    Wire box(const std::string& type, const std::string& instance, const std::vector<BoxInput>& inputs,
             const std::vector<std::string>& outputs, size_t main = 0, bool isNegated = false);
    /// One wire of several; none of none.
    Wire joined(const char* type, const std::vector<Wire>& wires);
    /// A coil or variable that takes what arrives.
    void target(const std::string& text, const Wire& from, const PinMarks& marks);
    /// Without a label: RETURN.
    void jump(const std::string& label, const Wire& from, bool isNegated);

private:
    pugi::xml_node add(const char* kind);

    pugi::xml_node m_body;
    int m_last = 0;
    bool m_isLadder;
};

} // namespace plc::exchange
