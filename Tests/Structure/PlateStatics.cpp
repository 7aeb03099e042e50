#include "PlateStatics.h"

#include <antinode_structure/SolvedPlate.h>
#include <antinode_structure/StaticShare.h>

namespace antinode
{
Eigen::MatrixXd staticShapes (const PlateDescription& plate, const PlateSolution& solution, const PlateGrid& grid)
{
    return shapesOn (grid, solution.problem, solution.layout.unit, staticDeflections (plate, solution));
}
} // namespace antinode
