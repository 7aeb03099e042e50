#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/Library.h>
#include <antinode_structure/DeviceDescription.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("The first 15 modes of embedded devices are right to 3 % while they are drawn, and masses to 0.1 %")
{
    constexpr Eigen::Index compared = 15;
    constexpr int whileDrawn = 30;

    for (const auto& name : factoryNames (LibraryKind::device))
    {
        INFO (name);
        const auto device = readDevice (loadDocument (LibraryKind::device, name), name);
        const auto coarse = solveCoarsely (device, whileDrawn), exact = solveStructure (device, compared);
        const auto ratios = coarse.angularFrequencies.head (compared).cwiseQuotient (exact.angularFrequencies);
        CHECK (coarse.modes() == whileDrawn);
        CHECK ((ratios.array() - 1).cwiseAbs().maxCoeff() < 0.03); // Edges of thin and round ceramics do not bend them.
        CHECK (coarse.actuators() == exact.actuators());
        CHECK (coarse.surface.masses.sum() == Approx (exact.surface.masses.sum()).epsilon (1e-3));
    }
}
