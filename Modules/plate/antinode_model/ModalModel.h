#pragma once

#include "Surface.h"

#include <antinode_outline/Outline.h>

#include <string>
#include <vector>

namespace antinode
{
/** The dielectric loss factor of soft ceramics (PZT-5A) at low fields: taken where none is given. */
inline constexpr double usualLossFactor = 0.02;

/** By how much a ceramic's motion comes after the voltage that is asked for, beside what all modes do. Docs/Theory.md,
   section 7.9. */
struct InputLag
{
    double delay = 0;        ///< s, 0 or more: after the ceramic that is first.
    double timeConstant = 0; ///< s, of a low-pass of first order.
    double angle = 0;        ///< rad, the same at all frequencies: hysteresis.

    bool operator== (const InputLag&) const = default;
};

/** A ceramic (bimorph): its extent and limits. Ceramic k is output channel k. */
struct Ceramic
{
    std::string name;
    double xMinimum = 0, xMaximum = 0;   ///< Extent, m.
    double yMinimum = 0, yMaximum = 0;   ///< Extent, m; both 0 on a line.
    double voltageLimit = 0;             ///< U_max, V, at least 0.
    double slewLimit = 0;                ///< max |dU/dt|, V/s, whatever it follows from; 0: none.
    double capacitance = 0;              ///< What its amplifier charges, F; 0: unknown.
    double lossFactor = usualLossFactor; ///< tan delta of the capacitance.
    double area = 0;                     ///< Of one face, m^2; 0: unknown.
    double currentLimit = 0;     ///< Of its amplifier, A; 0: none. With the capacitance it limits the slew rate.
    double amplifierVoltage = 0; ///< What its amplifier gives for a full-scale sample, V; 0: the device's full scale.
    InputLag lag {};             ///< Undone before the outputs.
    Outline outline {}; ///< m, of one that does not fill its extent: a disc, a ring, a turned rectangle; else empty.
};

/** Where the modes of a device come from. */
enum class ModeSource
{
    given,   ///< A file has them and says no more.
    drawn,   ///< Computed from a drawing.
    retuned, ///< Drawn; frequencies, damping and participations by measurement.
    measured ///< Shapes too.
};

/** How modes came about, by which a design knows how far a device may be from them. Docs/Theory.md, section 7.4. */
struct ModeOrigin
{
    ModeSource source = ModeSource::given;
    int points = 0;           ///< Where they were measured.
    double unexplained = 0;   ///< What they leave of what was measured there, RMS over RMS.
    bool scaleIsKnown = true; ///< False: shapes have a size by convention; forces on the surface mean nothing to them.

    bool operator== (const ModeOrigin&) const = default;
};

/** A device as its modes: all that focus and engine know of it, computed or measured.

    N_m flexible modes, ascending in frequency; N_p points; N_b ceramics. The shapes are mass-normalised over the whole
    body: integral m phi_k phi_l = delta_kl. Docs/Theory.md, section 1; paper (13) to (23).

    Modes are real, or all are complex, where damping is not proportional. Complex ones have their real parts where real
    ones have theirs, and their imaginary parts behind them: shapes and slopes have twice as many columns, participation
    twice as many rows. So the columns of shapes belong to N_c coordinates, N_m or 2 N_m of them, and a field is shapes
    times the coordinates' velocities, whatever the modes are. Docs/Theory.md, section 1.11.
*/
struct ModalModel
{
    std::string name;
    Surface surface;
    Eigen::VectorXd angularFrequencies; ///< N_m: omega_k, rad/s, undamped.
    Eigen::VectorXd dampingRatios;      ///< N_m: xi_k, 0 < xi < 1.
    Eigen::MatrixXd shapes;             ///< N_p x N_c: phi_k normal to the surface, kg^-1/2.
    Eigen::MatrixXd slopes;             ///< N_p x N_c: dphi_k/dx, kg^-1/2 / m. On a line only, else empty.
    Eigen::MatrixXd participation;      ///< N_c x N_b: alpha_ki, N kg^-1/2 / V.
    Eigen::MatrixXd staticShare;   ///< N_p x N_b: how far modes beyond these bend it, far below them, m/V; measured,
                                   ///< else empty: solveWithStaticShare has it of plates.
    std::vector<Ceramic> ceramics; ///< N_b
    double fullScaleVoltage = 1;   ///< The voltage of a sample of 1.0 in files and at the outputs, V.
    bool coversWholeBody =
        true; ///< False if shapes are measured on a part only; fields are then projected by least squares.
    int rigidBodyModes = 0;            ///< Number of rigid-body modes (frequency 0) in addition to the flexible modes.
    int unknowns = 0;                  ///< Degrees of freedom of the solution; 0 where measured.
    Eigen::VectorXd frequencyErrors;   ///< N_m: estimated relative error of each frequency; empty if unknown.
    std::vector<std::string> warnings; ///< Sentences for the user about the accuracy of the model.
    ModeOrigin origin;

    Eigen::Index modes() const { return angularFrequencies.size(); }
    Eigen::Index points() const { return shapes.rows(); }
    Eigen::Index actuators() const { return participation.cols(); }
    Eigen::Index coordinates() const { return hasComplexModes() ? 2 * modes() : modes(); }
    bool hasComplexModes() const { return participation.rows() > modes(); }
    double frequencyHz (Eigen::Index mode) const;
};

/** What a ceramic can be given, V: its own limit, or what a full-scale sample stands for where that is less, since no
   output gives more. [any] Docs/Design/allocation.md */
double voltageLimit (const ModalModel&, std::size_t ceramic);

/** The same of every ceramic: N_b, V. [any] */
Eigen::VectorXd voltageLimits (const ModalModel&);

/** How quickly the voltage of every ceramic may change: N_b, V/s; 0: as quickly as it likes. [any] */
Eigen::VectorXd slewLimits (const ModalModel&);

/** The decay rate a = xi omega of every mode, 1/s. [any] */
Eigen::VectorXd decayRates (const ModalModel&);

/** The damped angular frequency b = omega sqrt (1 - xi^2) of every mode, rad/s. [any] */
Eigen::VectorXd dampedFrequencies (const ModalModel&);

/** The row of mode shapes at one place of the surface.
    @param x, y  m, inside the surface (y is 0 on a line)
    @return      N_c values, kg^-1/2: cubic Hermite between points on a line, the polynomial of a grid's segments on a
   computed plate, thin-plate spline through scattered points
    @throws InputError  when the place lies outside the surface
    [worker] Docs/Theory.md, section 1.5. */
Eigen::RowVectorXd shapesAt (const ModalModel&, double x, double y);

/** A model whose slopes are filled in by the natural cubic spline through the points of a line. [worker]
    @throws InputError  when points do not ascend in x */
ModalModel withSplineSlopes (ModalModel);

/** How far each mode is from real: the modal phase collinearity, 1 of a real one and of modes that are real. N_m
    [any] Docs/Theory.md, section 8.5. */
Eigen::VectorXd phaseCollinearities (const ModalModel&);

/** Refuses complex modes where only real ones are known to be right.
    @param what  what takes real modes only, a plural: "tolerance studies"
    @throws InputError  when the modes are complex
    [any] */
void requireRealModes (const ModalModel&, const std::string& what);

/** Refuses shapes whose size is a convention where forces act on the surface: there it counts.
    @param what  what needs the size, a plural: "fingers"
    @throws InputError  naming the device and what gives it the size
    [any] Docs/Theory.md, section 8.6. */
void requireKnownScale (const ModalModel&, const std::string& what);

/** Measured points in one half wave of the mode of such a number: of a line, or of the waves that as many modes have in
    the plane. [any] */
double pointsPerHalfWave (const Eigen::MatrixX2d& points, Eigen::Index mode);

/** Below it points between which nothing is known hide what a shape does. */
inline constexpr double enoughPointsPerHalfWave = 2.5;

/** How many modes, the lowest, the points of a measured device show; all modes of others. [any] */
Eigen::Index resolvedModes (const ModalModel&);

/** The model on some of its points, in their order; without a grid, which they no longer fill. [any] */
ModalModel onPoints (ModalModel, const std::vector<Eigen::Index>& points);

/** Checks a model: sizes agree, numbers are finite, 0 < xi < 1, frequencies ascend and are positive; complex shapes do
    not claim to be orthogonal.
    @throws InputError  naming the first thing that is wrong. [worker] */
void validate (const ModalModel&);

/** A device whose idle ceramics move nothing: they listen.
    @param idle  counted from 1; each is on the device
    [any] */
ModalModel withoutDrive (ModalModel, const std::vector<int>& idle);

/** s: by how much a ceramic may act after the first of its device, and the longest low-pass before it; what files may
   say and filters undo. Docs/FileFormats.md. */
inline constexpr double longestLag = 0.01;

/** The mode shapes at several places of the surface.
    @param places  x, y in m, one row per place
    @return        places x N_c, kg^-1/2, as shapesAt() gives each row
    @throws InputError  when a place lies outside the surface
    [worker] Docs/Theory.md, section 1.5. */
Eigen::MatrixXd shapesAtPlaces (const ModalModel&, const Eigen::MatrixX2d& places);
} // namespace antinode
