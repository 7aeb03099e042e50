#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace antinode
{
/** A mode of a finite-element program. N nodes. */
struct ElementMode
{
    double frequency = 0;    ///< Hz, undamped.
    double dampingRatio = 0; ///< 0 where the program says none.
    Eigen::MatrixX3cd
        shape; ///< N x 3, mass-normalised: kg^-1/2 once units are those of SI; real ones without imaginary part.
};

/** One element of a mesh. */
struct MeshElement
{
    std::int64_t material = 0;       ///< Its material, or property, by the file's number.
    std::vector<Eigen::Index> nodes; ///< As indices.
};

/** What a finite-element program computed, as files have it. N nodes; vectors along x, y, z, in the units of the file.
 */
struct ElementResults
{
    std::vector<std::int64_t> labels; ///< N: of the nodes.
    Eigen::MatrixX3d places;          ///< N x 3
    std::vector<MeshElement> elements;
    std::vector<ElementMode> modes;
    std::vector<Eigen::MatrixX3d> blockedForces; ///< A ceramic each: what holds all nodes at the case's voltage, N x 3.
    std::vector<Eigen::MatrixX3d> staticDisplacements; ///< A ceramic each, or none: of the body as it is held, N x 3.
    double totalMass = 0;                              ///< As a table of the program says, 0: it does not.

    Eigen::Index nodes() const { return places.rows(); }
    bool hasComplexModes() const;
};

/** What stands in a file of CalculiX (.frd, its .dat with a table of participation factors) or a universal file.
    @param source  how errors name it
    @throws InputError  source, line, what is wrong
    [worker] Docs/FileFormats.md, Docs/Manual/importing.md */
ElementResults readElementResults (std::string_view bytes, const std::string& source);

/** Results in mm, t, N and s in SI units. [any] */
ElementResults fromMillimetres (ElementResults);

/** Results of several files as one: nodes of the first that has some, modes of the first that has some, forces and
    displacements of all in their order.
    @throws InputError  where files are of different meshes, or nothing is left to import
    [worker] */
ElementResults mergedResults (std::vector<ElementResults>);
} // namespace antinode
