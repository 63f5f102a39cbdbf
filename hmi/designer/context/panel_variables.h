// What bindings of one panel can name: its parameters ("$valve", "$valve.Opened") and the variables of the project. A
// parameter is taken for a variable of its type, so that the program need not have one. It reads the document and the
// context each time and keeps nothing; both must outlive it. GUI thread.
#pragma once
#include "hmi/designer/context/design_context.h"
#include "hmi/model/faceplate.h"
#include "runtime/image/variable_tree.h"

namespace plc::hmi {

class PanelVariables final : public kit::VariableProvider {
public:
    PanelVariables(const DesignContext& context, const PanelDocument& document)
        : m_context(context), m_document(document) {}

    const DesignContext& context() const { return m_context; }
    /// The parameters that stand for values, not those that are pieces of text.
    std::vector<Parameter> parameters() const;

    std::vector<kit::VariableNode> children(const QString& path) const override;
    std::vector<kit::VariableNode> search(const QString& text, int limit) const override;

    /// Of a path of the project, or one that begins with a parameter; nothing where the type is not known.
    std::optional<TypedExpression> typed(const QString& path) const;
    /// Why a binding cannot be this; empty where it can, or where only the check of the whole panel knows.
    QString complaint(const QString& expression, std::string_view wanted, bool isTarget) const;
    /// Parameters and their members that continue the word left of the cursor, then what the project offers.
    std::vector<kit::Completion> complete(const QString& text, int cursor) const;
    /// Lets the user choose; nothing when it was cancelled.
    std::optional<QString> pick(const QString& present, QWidget* parent) const;

private:
    image::Layout layout() const;
    const kit::VariableProvider* ofProject() const;
    const DesignContext& m_context;
    const PanelDocument& m_document;
};

} // namespace plc::hmi
