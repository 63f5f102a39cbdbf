// What a debugger's tree of variables unfolds: each line has a name, a value as text and, where it has parts, a number
// to ask for them by. The numbers are good as long as the program stands. Owned by the adapter.
#pragma once
#include "projects/protocol/json_rpc.h"
#include "runtime/types/value.h"

#include <functional>

namespace plc::dap {

using protocol::Json;

class Variables {
public:
    struct Line {
        std::string name;
        types::Value value; // no value: not connected
        std::string path;   // from the top; empty: it has none (a local of a call)
        bool isChanged = false;
    };
    /// The lines of a number are made when they are asked for.
    using Lines = std::function<std::vector<Line>()>;

    void clear() { m_parts.clear(); }
    [[nodiscard]] int64_t add(Lines lines);
    /// None: there is no such number any more.
    [[nodiscard]] std::optional<std::vector<Line>> lines(int64_t number) const;
    [[nodiscard]] Json toJson(const types::TypeTable& types, const Line& line);
    /// Value, type and number of parts, as `evaluate` and `variables` show them.
    [[nodiscard]] Json valueJson(const types::TypeTable& types, const Line& line, const char* key);

private:
    std::vector<Lines> m_parts;
};

/// The elements of an array, the members of a structure or block; of the others none.
[[nodiscard]] std::vector<Variables::Line> partsOf(const types::TypeTable& types, const Variables::Line& line);

} // namespace plc::dap
