// The tree of a program's variables as pickers and completion show it; and the unit that a declaration's comment names
// in brackets. The program is shared and immutable; GUI thread.
#pragma once

#include "editor/kit/inputs/expression_edit.h"
#include "editor/kit/inputs/variable_picker.h"
#include "runtime/image/program.h"

namespace plc::trace {

class ProgramVariables final : public kit::VariableProvider {
public:
    void setProgram(std::shared_ptr<const image::CompiledProgram> program) { m_program = std::move(program); }

    std::vector<kit::VariableNode> children(const QString& path) const override;
    std::vector<kit::VariableNode> search(const QString& text, int limit) const override;

    /// Names that continue the path left of the cursor.
    [[nodiscard]] std::vector<kit::Completion> complete(const QString& text, int cursor) const;
    /// "°C" for a variable declared with a comment such as "actual value [°C]"; empty when it names none.
    [[nodiscard]] QString unitOf(const QString& path) const;

private:
    std::shared_ptr<const image::CompiledProgram> m_program;
};

} // namespace plc::trace
