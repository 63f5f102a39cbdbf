// The elements of a diagram in PLCopen XML, for the tests that draw one.
#pragma once
#include <initializer_list>
#include <string>

namespace plc::exchange {

inline std::string in(const std::string& id, const std::string& pin = {}) {
    return "<connectionPointIn><connection refLocalId=\"" + id + "\"" +
           (pin.empty() ? "" : " formalParameter=\"" + pin + "\"") + "/></connectionPointIn>";
}
inline std::string at(int y, int x = 0) {
    return "<position x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\"/>";
}
inline std::string contact(const std::string& id, const std::string& name, const std::string& from,
                           const std::string& more = {}) {
    return "<contact localId=\"" + id + "\" " + more + ">" + at(0) + in(from) + "<connectionPointOut/><variable>" +
           name + "</variable></contact>";
}
inline std::string coil(const std::string& id, const std::string& name, const std::string& connection, int y,
                        const std::string& more = {}) {
    return "<coil localId=\"" + id + "\" " + more + ">" + at(y) + connection + "<connectionPointOut/><variable>" +
           name + "</variable></coil>";
}
inline std::string value(const std::string& id, const std::string& text, const std::string& more = {}) {
    return "<inVariable localId=\"" + id + "\" " + more + ">" + at(0) + "<connectionPointOut/><expression>" + text +
           "</expression></inVariable>";
}
inline std::string target(const std::string& id, const std::string& text, const std::string& connection, int y = 100) {
    return "<outVariable localId=\"" + id + "\">" + at(y) + connection + "<expression>" + text +
           "</expression></outVariable>";
}
inline std::string input(const std::string& pin, const std::string& from, const std::string& more = {}) {
    return "<variable formalParameter=\"" + pin + "\" " + more + ">" + from + "</variable>";
}
inline std::string block(const std::string& id, const std::string& type, const std::string& instance,
                         const std::string& inputs, std::initializer_list<const char*> outputs, int y = 0) {
    std::string out = "<block localId=\"" + id + "\" typeName=\"" + type + "\"" +
                      (instance.empty() ? "" : " instanceName=\"" + instance + "\"") + ">" + at(y) +
                      "<inputVariables>" + inputs + "</inputVariables><inOutVariables/><outputVariables>";
    for (const char* each : outputs)
        out += "<variable formalParameter=\"" + std::string(each) + "\"><connectionPointOut/></variable>";
    return out + "</outputVariables></block>";
}
inline const std::string kRail = "<leftPowerRail localId=\"1\"><position x=\"0\" y=\"0\"/><connectionPointOut "
                                 "formalParameter=\"\"/></leftPowerRail>";

} // namespace plc::exchange
