#pragma once

#include <antinode_tasks/Field.h>

#include <CLI/CLI.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace antinode
{
/** Reads the devices, focuses, waveforms and places that options named, once; to be called before the task. */
struct ReadFields
{
    std::function<void()> read;
    std::shared_ptr<const std::vector<std::string>> assignments; ///< The values of --set.

    void operator()() const { read(); }
};

/** Adds the fields of a request to a sub-command as options, and --set where they name documents. What they point to
   must live as long as the app. [worker] */
ReadFields addFields (CLI::App&, const std::vector<Field>&);
} // namespace antinode
