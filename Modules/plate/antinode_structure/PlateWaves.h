#pragma once

#include "DeviceDescription.h"
#include "PlateSection.h"

#include <complex>
#include <string>
#include <vector>

namespace antinode
{
/** Whether modes have other frequencies than those of a thin plate of one section: soft layers, Mindlin's theory.
    [any] */
bool needsCorrection (const StructureCommon&);

/** What is solved in place of a description that needs correction: a thin plate whose soft layers are taken at a wave
    number, with a maximum frequency that such a plate has where the wanted one lies.
    @param waveNumber  in the middle of the modes, rad/m; where the description has a maximum frequency, half of the
                       wave number there is taken
    [any] Docs/Theory.md, section 1.15. */
StructureCommon asSolved (StructureCommon, double waveNumber);

/** Gives solved modes the frequencies that waves of their length have on the bare plate, adds the damping of soft
   layers and scales participation by the moment per volt at that length. Parts with ceramics are taken to change as the
   bare plate does; shapes stay.
    @param common  as solved
    [worker] Docs/Theory.md, sections 1.7 and 1.15. */
void correctFrequencies (ModalModel&, const StructureCommon&);

/** The wave number of bending waves on the bare plate, rad/m; of an orthotropic one along its softer direction. [any]
 */
double waveNumberAt (const StructureCommon&, double angularFrequency);

/** That of the shortest waves anywhere: of the bare plate, or of a ceramic that is heavier than it is stiff, rad/m.
    [any] */
double largestWaveNumberAt (const StructureCommon&, double angularFrequency);

/** The reverse of waveNumberAt, rad/s. [any] */
double angularFrequencyAt (const StructureCommon&, double waveNumber);

/** A wave number, rad/m, that the given number of modes hardly exceeds: Weyl's law with its term for the edges, and for
   narrow plates the modes of a strip. [any] Docs/Theory.md, section 1.6. */
double expectedWaveNumber (const PlateDescription&, int modeCount);

/** A warning where waves are so short compared with the thickness that thin-plate theory overestimates frequencies, or
    by how much they are corrected; empty if it is right to 2 %, and for laminates that shear in soft layers.
    @param angularFrequencies  of the modes, ascending
    [any] Docs/Theory.md, section 1.7; Mindlin, J. Appl. Mech. 18 (1951) 31-38. */
std::vector<std::string> thicknessWarnings (const StructureCommon&, const Eigen::VectorXd& angularFrequencies);

/** Whether a laminate has a layer whose modulus depends on frequency. [any] */
bool hasSoftLayers (const StructureCommon&);

/** The bending stiffness of the bare plate, the geometric mean of both directions, N m; its phase is the loss.
    @param waveNumber        rad/m
    @param angularFrequency  at which soft layers are taken, rad/s
    [any] */
std::complex<double> stiffnessAt (const StructureCommon&, double waveNumber, double angularFrequency);

/** The frequency of bending waves on a bare plate with soft layers, rad/s, and their loss factor. */
struct LossyFrequency
{
    double angularFrequency = 0; ///< The root of the real part of omega^2.
    double lossFactor = 0;       ///< The imaginary part of omega^2 over the real one.
};

/** omega^2 = k^4 D (k, omega) / m, which on a simply supported sandwich is exact. [any] Mead and Markus, J. Sound Vib.
    10 (1969) 163; Docs/Theory.md, section 1.15. */
LossyFrequency lossyFrequencyAt (const StructureCommon&, double waveNumber);

/** Bending waves on the thin bare plate have the angular frequency k^2 times this, m^2/s; the geometric mean of both
    directions. [any] */
double thinWaveFactor (const StructureCommon&);

/** The frequency of bending waves on a bare plate after Mindlin, with shear and rotary inertia, rad/s. On a simply
    supported plate, whose modes have the wave numbers of thin-plate theory, it is exact within his theory.
    @param waveNumber  rad/m
    [any] Mindlin, J. Appl. Mech. 18 (1951) 31-38; Docs/Theory.md, section 1.7. */
double mindlinFrequencyAt (const StructureCommon&, double waveNumber);
} // namespace antinode
