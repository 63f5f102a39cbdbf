#include "app/cli/program/commands.h"

#include "app/cli/kit/errors.h"
#include "projects/analysis/explanation.h"
#include "runtime/platform/streams.h"

#include <iostream>

namespace plc::cli {

namespace {

void list() {
    for (const std::string_view code : analysis::diagnosticCodes())
        if (const auto shown = analysis::explain(code); shown && !shown->findings.empty())
            std::cout << code << "  " << shown->findings.front().message.english() << "\n";
}

int explain(const Arguments& arguments) {
    if (arguments.paths().empty()) {
        list();
        return kGood;
    }
    for (const std::string& code : arguments.paths()) {
        const auto shown = analysis::explain(code);
        if (!shown) return wrongUse({errors::NoSuchCode(code), ""});
        for (const diagnostics::Diagnostic& finding : shown->findings)
            std::cout << diagnostics::renderText(*shown->checkedWrong.sources, finding,
                                                 wantsColours(platform::kStandardOutput));
        std::cout << "\nWrong:\n"
                  << analysis::numbered(shown->wrong) << "\nRight:\n"
                  << analysis::numbered(shown->right);
    }
    return kGood;
}

} // namespace

Command explainCommand() {
    return {{"explain",
             "[CODE…]",
             "Shows what a code means: a program that causes it, and a correct one. Without a code, all codes.",
             {},
             "stepwise explain P3025"},
            explain};
}

} // namespace plc::cli
