// Which instances of a POU a program has, and the one whose values its text shows. What was found is kept until another
// program is asked about. Owned by RunControl; GUI thread.
#pragma once
#include "runtime/image/program.h"

#include <QString>

#include <map>
#include <memory>
#include <vector>

namespace plc::editor {

class PouInstances {
public:
    /// Paths of the instances in that program, found once for each POU.
    [[nodiscard]] const std::vector<QString>& of(const QString& pou,
                                                 const std::shared_ptr<const image::CompiledProgram>& program) const;
    /// The block that an expression names or lies in, and the path of its instance; both empty outside of one.
    [[nodiscard]] static std::pair<QString, QString> at(const QString& expression,
                                                        const std::shared_ptr<const image::CompiledProgram>& program);
    void prefer(const QString& pou, const QString& instance) { m_preferred[pou.toLower()] = instance; }
    /// The one that was chosen, else the first.
    [[nodiscard]] QString preferred(const QString& pou,
                                    const std::shared_ptr<const image::CompiledProgram>& program) const;

private:
    std::map<QString, QString> m_preferred;                  // POU → path
    mutable std::map<QString, std::vector<QString>> m_found; // by POU, of m_foundIn
    mutable std::shared_ptr<const image::CompiledProgram> m_foundIn;
};

} // namespace plc::editor
