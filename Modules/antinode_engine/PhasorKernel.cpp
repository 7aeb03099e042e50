#include "PhasorKernel.h"

#include <limits>

// Highway includes this file once a target, each time with another HWY_NAMESPACE.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "antinode_engine/PhasorKernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace antinode::HWY_NAMESPACE
{
namespace
{
namespace hn = hwy::HWY_NAMESPACE;

template <typename Tag, typename Vector>
HWY_INLINE void storeAs (Tag narrow, Vector values, float* target)
{
    hn::StoreU (hn::DemoteTo (narrow, values), narrow, target);
}

template <typename Tag, typename Vector>
HWY_INLINE void storeAs (Tag wide, Vector values, double* target)
{
    hn::StoreU (values, wide, target);
}

template <typename Sample>
HWY_INLINE void findStripPhasors (const SoundingOscillation& oscillation, int strip, Sample* phasors)
{
    const hn::CappedTag<double, synthesisStrip> wide;
    const hn::Rebind<Sample, decltype (wide)> narrow;
    const auto minimum = hn::Set (
        wide, static_cast<double> (std::numeric_limits<Sample>::min() / std::numeric_limits<Sample>::epsilon()));
    const auto* turns = oscillation.turns + strip * 2 * synthesisStrip;
    const auto anchorReal = hn::Set (wide, oscillation.anchorReal);
    const auto anchorImaginary = hn::Set (wide, oscillation.anchorImaginary);

    for (int t = 0; t < synthesisStrip; t += static_cast<int> (hn::MaxLanes (wide)))
    {
        const auto turnReal = hn::Load (wide, turns + t);
        const auto turnImaginary = hn::Load (wide, turns + synthesisStrip + t);
        const auto real = hn::NegMulAdd (anchorImaginary, turnImaginary, hn::Mul (anchorReal, turnReal));
        const auto imaginary = hn::MulAdd (anchorImaginary, turnReal, hn::Mul (anchorReal, turnImaginary));
        const auto audible = hn::Ge (hn::Max (hn::Abs (real), hn::Abs (imaginary)), minimum);
        storeAs (narrow, hn::IfThenElseZero (audible, real), phasors + t);
        storeAs (narrow, hn::IfThenElseZero (audible, imaginary), phasors + synthesisStrip + t);
    }
}

/** In a loop of its own: what is stored here must have reached the cache before single numbers are read from it. */
template <typename Sample>
void findPhasors (SynthesisChunk<Sample>& chunk, int strip)
{
    for (int c = 0; c < chunk.count; ++c)
        findStripPhasors (chunk.sounding[c], strip, chunk.phasors + c * 2 * synthesisStrip);
}
} // namespace

PhasorKernel<double> doublePhasorKernel()
{
    return &findPhasors<double>;
}

PhasorKernel<float> floatPhasorKernel()
{
    return &findPhasors<float>;
}
} // namespace antinode::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace antinode
{
namespace
{
HWY_EXPORT (doublePhasorKernel);
HWY_EXPORT (floatPhasorKernel);
} // namespace

template <>
PhasorKernel<double> phasorKernel<double>()
{
    return HWY_DYNAMIC_DISPATCH (doublePhasorKernel)();
}

template <>
PhasorKernel<float> phasorKernel<float>()
{
    return HWY_DYNAMIC_DISPATCH (floatPhasorKernel)();
}
} // namespace antinode
#endif
