#pragma once

#include <antinode_model/ModalModel.h>

#include <complex>
#include <vector>

namespace antinode
{
/** What an amplifier makes of the voltage that it is asked for. */
struct Amplifier
{
    double gain = 1;
    double timeConstant = 0; ///< s, of its low-pass of first order: 1 / (2 pi bandwidth); 0: none.
    double delay = 0;        ///< s, beside that of the low-pass.
};

/** Its voltage per wanted voltage at a frequency in Hz: gain exp (-i omega delay) / (1 + i omega timeConstant). [any]
 */
std::complex<double> responseOf (const Amplifier&, double frequency);

/** An amplifier that was measured. */
struct MeasuredAmplifier
{
    Amplifier amplifier;
    double misfit = 0; ///< RMS of what its response has beside, relative to it.
};

/** The amplifier whose response comes nearest to a measured one, by least squares: a line through the inverse squares
   first, then Gauss and Newton's method.
    @param frequencies  Hz, at least 3, ascending, less than half a period of the delay apart
    @param response     V per V, as many
    @throws InputError  where it is not finite or 0
    [worker] Docs/Theory.md, section 7.9. */
MeasuredAmplifier fitAmplifier (const Eigen::VectorXd& frequencies, const Eigen::VectorXcd& response);

/** A device with the amplifiers in front of it: participations by their gains, so that designs ask for the voltages
   that come out right, and limits so that no ceramic gets more than its own. The low-pass and the delay after the
   amplifier that is first become the lag of the ceramic, which is undone before the outputs.
    @param amplifiers  N_b
    @throws InputError  where there are not as many, one has a gain of 0 or less, or the device has amplifiers already
    [worker] */
ModalModel throughAmplifiers (ModalModel, const std::vector<Amplifier>& amplifiers);

/** By how much a ceramic's voltage comes late at a frequency in Hz, s: the delay and the low-pass together. [any] */
double lateness (const Amplifier&, double frequency);
} // namespace antinode
