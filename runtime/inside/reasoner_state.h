// What the files that implement Reasoner share.
#pragma once
#include "runtime/inside/why.h"

namespace plc::inside {

/// A question at a scan.
struct Reasoner::Asked {
    Question question;
    Position at = 0;
    history::ScanStamp stamp;
    std::shared_ptr<const image::CompiledProgram> program;
    std::vector<std::byte> image;
    expression::Expression expression;
    std::string value;
    /// The value in an image, in words of ST; "" when it has none.
    [[nodiscard]] std::string text(std::span<const std::byte> bytes) const {
        if (bytes.size() < program->layout.dataEnd) return {};
        const expression::Outcome outcome = expression.evaluate(bytes);
        return outcome.hasValue() ? types::toText(expression.types(), outcome.value) : std::string();
    }
};

} // namespace plc::inside
