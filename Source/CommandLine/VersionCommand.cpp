#include "Commands.h"

#include <juce_core/juce_core.h>

#include <Eigen/Core>

#include <cstdio>

namespace antinode
{
void addVersionCommand (CLI::App& app)
{
    app.add_subcommand ("version", "Prints the version and the versions of the libraries")
        ->callback (
            []
            {
                std::printf ("antinode %s (JUCE %d.%d.%d, Eigen %d.%d.%d)\n", ANTINODE_VERSION, JUCE_MAJOR_VERSION,
                             JUCE_MINOR_VERSION, JUCE_BUILDNUMBER, EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                             EIGEN_MINOR_VERSION);
            });
}
} // namespace antinode
