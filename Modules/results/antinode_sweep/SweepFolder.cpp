#include "SweepFolder.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <system_error>

namespace antinode
{
PartFolder sweepFolder (const std::filesystem::path& path, const SweepInputs& inputs)
{
    std::error_code error;
    const auto plan = path / "plan.json";

    if (! path.empty() && std::filesystem::exists (plan, error) && loadSweep (plan).hash != inputs.hash)
        throw InputError (printable (path.string(), 300), "holds parts of another plan, or of another version of the "
                                                          "program; choose another folder");

    PartFolder folder (path, inputs.hash, inputs.plan.cases);

    if (! std::filesystem::exists (plan, error))
        writeAtomically (plan, inputs.document.dump (2) + "\n");

    return folder;
}
} // namespace antinode
