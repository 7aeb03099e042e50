#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The excitation of the surface, one column per reference. */
enum class DriveQuantity
{
    voltage, ///< A ceramic's voltage, V.
    force    ///< A force normal to the surface, N: a hammer or a shaker.
};

/** One reference: a ceramic, or a position where a hammer hits. */
struct Reference
{
    std::string name;
    std::optional<Eigen::Index> point; ///< The measured point at which a force acts, if it is one of them.
};

/** Velocities of points per drive, as they were measured: what identification starts from. N_f lines, N_p points, N_b
   references.

    H(p, i) = v_p / U_i with exp (+i omega t); a mode gives phi_p alpha_i i omega / (omega_k^2 - omega^2 + 2 i xi_k
   omega_k omega) exp (-i omega delay). Docs/Theory.md, section 8.1.
*/
struct FrequencyResponses
{
    Eigen::VectorXd frequencies; ///< N_f: Hz, ascending, at least 0.
    DriveQuantity drive = DriveQuantity::voltage;
    std::vector<Reference> references;      ///< N_b; reference k is output channel k.
    Eigen::MatrixX2d points;                ///< N_p x 2: x and y, m.
    std::vector<Eigen::MatrixXcd> values;   ///< N_b of N_f x N_p: (m/s)/V or (m/s)/N; not finite where not measured.
    std::vector<Eigen::MatrixXd> variances; ///< As values: E |error|^2 of each, the unit squared; empty if unknown.
    /** How often what was measured was integrated to velocities: 1 accelerations, -1 displacements. Its noise is taken
        to be white. */
    int integrations = 0;
    /** Whether something says what was measured. If nothing does, values are the numbers as they are, as if they were
        velocities, and identification finds out what they are. */
    bool isQuantityStated = true;
};

/** Checks what all who read them rely on: sizes agree, frequencies ascend, references' points exist. Values may be not
   finite.
    @throws InputError  naming the first thing that is wrong [worker] */
void validate (const FrequencyResponses&);
} // namespace antinode
