// Which argument of a standard function's call belongs to which parameter.
#include "runtime/compiler/sema/calls/standard_calls.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/names/lookup.h"

#include "runtime/base/text.h"

namespace plc::sema {

using library::Signature;
using syntax::ArgumentKind;

namespace {

// MAX, ADD, MUX and others take any number of inputs (tables 24 to 28, "extensible"); a name that is given by
// number is found without a list of all of them.
/// IN3, IN4, … behind the last parameter of a function that takes any number.
std::optional<size_t> furtherParameter(const Signature& signature, std::string_view name) {
    const size_t count = signature.parameters.size();
    if (!signature.isExtensible || count == 0) return std::nullopt;
    const std::string_view last = signature.parameters.back().name;
    const size_t digits = last.find_first_of("0123456789");
    if (digits == std::string_view::npos || name.size() <= digits ||
        !equalsIgnoringCase(last.substr(0, digits), name.substr(0, digits)))
        return std::nullopt;
    const int first = std::atoi(std::string(last.substr(digits)).c_str());
    const int number = std::atoi(std::string(name.substr(digits)).c_str());
    // A thousand: IN999999999 in a text that is only being typed must not make a list of that length.
    if (number <= first || number >= first + 1000) return std::nullopt;
    return count - 1 + static_cast<size_t>(number - first);
}

std::optional<size_t> parameterNamed(const Signature& signature, std::string_view name) {
    for (size_t i = 0; i < signature.parameters.size(); ++i)
        if (equalsIgnoringCase(signature.parameters[i].name, name)) return i;
    for (size_t i = 0; i < signature.parameters.size(); ++i)
        for (const std::string_view other : signature.parameters[i].otherNames)
            if (equalsIgnoringCase(other, name)) return i;
    return furtherParameter(signature, name);
}

/// One call's arguments while they are put in their places.
class Placing {
public:
    Placing(Context& context, const Signature& signature) : m_context(context), m_signature(signature) {
        m_out.inputs.resize(signature.parameters.size());
    }

    /// False: there are too many, and no more are looked at.
    bool add(const syntax::Argument& argument) {
        switch (argument.kind) {
        case ArgumentKind::Positional:
            return !argument.value || addPositional(argument);
        case ArgumentKind::Output:
            if (equalsIgnoringCase(argument.name.text, "ENO"))
                m_out.eno = &argument;
            else
                refuse(argument);
            return true;
        case ArgumentKind::Input:
            break;
        }
        // Each standard function has EN and ENO (2.5.1.2) without listing them.
        if (equalsIgnoringCase(argument.name.text, "EN")) {
            m_out.en = &argument;
        } else if (const auto index = parameterNamed(m_signature, argument.name.text)) {
            put(*index, argument);
        } else {
            std::vector<std::string> candidates;
            for (const library::Parameter& each : m_signature.parameters) candidates.emplace_back(each.name);
            suggest(m_context, refuse(argument), argument.name.range, argument.name.text, candidates);
        }
        return true;
    }

    StandardArguments finish(SourceRange callee) {
        for (size_t i = 0; i < m_out.inputs.size(); ++i) {
            if (m_out.inputs[i] && m_out.inputs[i]->value) continue;
            // With an argument that is unknown or too many, "is missing" is most often the same mistake said twice.
            if (!m_out.isGood) break;
            m_context.emit(callee,
                           findings::MissingArgument(nameOf(i, "IN" + std::to_string(i + 1)), m_signature.name));
            m_out.isGood = false;
        }
        return std::move(m_out);
    }

private:
    [[nodiscard]] std::string nameOf(size_t index, std::string otherwise) const {
        return index < m_signature.parameters.size() ? std::string(m_signature.parameters[index].name) : otherwise;
    }
    diagnostics::Diagnostic& refuse(const syntax::Argument& argument) {
        m_out.isGood = false;
        return m_context.emit(argument.name.range, findings::UnknownParameter(m_signature.name, argument.name.text));
    }
    bool addPositional(const syntax::Argument& argument) {
        const size_t count = m_signature.parameters.size();
        // Positional ones after named ones fill the gaps.
        while (m_next < m_out.inputs.size() && m_out.inputs[m_next]) ++m_next; // FIND(STR1 := a, b)
        if (m_next >= count && !m_signature.isExtensible) {
            m_context.emit(argument.range, findings::TooManyArguments(m_signature.name, count));
            m_out.isGood = false;
            return false;
        }
        put(m_next++, argument);
        return true;
    }
    void put(size_t index, const syntax::Argument& argument) {
        if (index >= m_out.inputs.size()) m_out.inputs.resize(index + 1);
        if (m_out.inputs[index]) {
            m_context.emit(argument.name.isValid() ? argument.name.range : argument.range,
                           findings::ArgumentTwice(nameOf(index, std::string(argument.name.text))));
            m_out.isGood = false;
        }
        m_out.inputs[index] = &argument;
    }

    Context& m_context;
    const Signature& m_signature;
    StandardArguments m_out;
    size_t m_next = 0;
};

} // namespace

/// Arguments of a standard function, by name (tables 22 to 36) or by position.
///   ok:    LIMIT(MN := 1.0, IN := r, MX := 2.0)      wrong: LIMIT(MN := 1.0, INN := r, MX := 2.0)  (P2009)
///          SIN(1.0, 2.0)  (P2011)   SIN()  (P2010)   SEL(G := b, G := b, IN0 := 1, IN1 := 2)  (P2012)
StandardArguments standardArguments(Context& context, const Signature& signature, const syntax::Expr& e) {
    Placing placing(context, signature);
    for (const syntax::Argument& argument : e.arguments)
        if (!placing.add(argument)) break;
    return placing.finish(e.base->range);
}

} // namespace plc::sema
