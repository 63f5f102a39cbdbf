#include "runtime/compiler/driver/object_file.h"

#include "runtime/base/messages.h"
#include "runtime/compiler/jit/object_code.h"
#include "runtime/image/portable_program.h"

namespace plc::driver {

Result<std::string> compileObject(const Built& built, const ObjectWanted& wanted) {
    if (!built.program) return Error{errors::NothingToOptimise(), ""};
    image::PortableProgram portable;
    portable.program = built.program;
    portable.name = wanted.name;
    portable.calendarStartNs = wanted.calendarStartNs;
    for (const SourceFile& file : built.input->files) portable.sources.emplace_back(file.path, file.text);
    portable.libraries = recordedSettings(*built.input);
    portable.libraryTexts = libraryTexts(*built.input);
    return jit::compileObject(*built.checked.analysis->program,
                              {wanted.triple, wanted.cpu, "stepwise_program", image::toBytes(portable)});
}

} // namespace plc::driver
