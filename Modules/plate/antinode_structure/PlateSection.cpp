#include "PlateSection.h"

#include "Materials.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace antinode
{
namespace
{
Eigen::Matrix3d planeStress (const ElasticMaterial& material)
{
    const auto poissonRatio21 = material.poissonRatio12 * material.youngsModulus2 / material.youngsModulus1;
    const auto divisor = 1 - material.poissonRatio12 * poissonRatio21;
    const auto coupling = material.poissonRatio12 * material.youngsModulus2;
    Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
    stiffness.topLeftCorner<2, 2>() << material.youngsModulus1, coupling, coupling, material.youngsModulus2;
    stiffness /= divisor;
    stiffness (2, 2) = material.shearModulus;
    return stiffness;
}

/** Strains (11, 22, 2 12) along the axes of a material that is turned by an angle, from those along x and y. */
Eigen::Matrix3d strainsAlong (double angle)
{
    const auto c = std::cos (angle), s = std::sin (angle);
    Eigen::Matrix3d turn;
    turn << c * c, s * s, c * s, s * s, c * c, -c * s, -2 * c * s, 2 * c * s, c * c - s * s;
    return turn;
}

/** Layers that are bonded without a soft one between them. */
struct Face
{
    Eigen::Matrix3cd stretching = Eigen::Matrix3cd::Zero(), coupling = Eigen::Matrix3cd::Zero(),
                     bending = Eigen::Matrix3cd::Zero();                               ///< A, B, D about the height 0.
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero(); ///< Per volt.

    void add (const SectionLayer& layer, double middle)
    {
        const auto h = layer.thickness;
        stretching += h * layer.stiffness;
        coupling += h * middle * layer.stiffness;
        bending += h * (middle * middle + h * h / 12) * layer.stiffness;
        force += h * layer.stressPerVolt;
        moment += h * middle * layer.stressPerVolt;
    }

    bool isEmpty() const { return stretching (0, 0) == 0.0; }

    /** How far its neutral plane lies above the height 0, for bending along x (0) or y (1). */
    std::complex<double> neutralPlane (Eigen::Index direction) const
    {
        return coupling (direction, direction) / stretching (direction, direction);
    }
};

/** A soft layer between two faces. */
struct Core
{
    std::complex<double> shearModulus;
    double thickness = 0, middle = 0;
};

/** How faces stretch and cores shear per curvature along one axis. */
struct Slip
{
    Eigen::VectorXcd stretches; ///< Of each face at its neutral plane, m.
    std::complex<double> shear; ///< Stiffness that the cores add, N m.
};

struct Stack
{
    std::vector<Face> faces;
    std::vector<Core> cores;
    double massPerArea = 0;
};

/** Faces and cores of layers. The height 0 is the middle of the stack. */
Stack stackOf (const std::vector<SectionLayer>& layers)
{
    double whole = 0;

    for (const auto& layer : layers)
        whole += layer.thickness;

    const auto isStiff = [] (const SectionLayer& layer) { return ! layer.softShearModulus; };
    const auto first = std::find_if (layers.begin(), layers.end(), isStiff);
    const auto last = std::find_if (layers.rbegin(), layers.rend(), isStiff).base();
    Stack stack { { {} }, {}, 0 };
    auto height = -whole / 2;

    for (auto layer = layers.begin(); layer != layers.end(); ++layer)
    {
        const auto middle = height + layer->thickness / 2;

        if (layer->softShearModulus && layer > first && layer < last)
        {
            stack.cores.push_back ({ *layer->softShearModulus, layer->thickness, middle });
            stack.faces.emplace_back();
        }
        else
            stack.faces.back().add (*layer, middle);

        stack.massPerArea += layer->density * layer->thickness;
        height += layer->thickness;
    }

    return stack;
}

/** The least energy: sum A e^2 + sum G / (h k^2) (step of e - step of the neutral planes)^2. Two soft layers that touch
   have a face of nothing between them. */
Slip slipAlong (const Stack& stack, Eigen::Index direction, double waveNumber)
{
    const auto count = static_cast<Eigen::Index> (stack.faces.size());
    Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Zero (count, count);
    Eigen::VectorXcd load = Eigen::VectorXcd::Zero (count), planes (count);

    for (Eigen::Index i = 0; i < count; ++i)
    {
        const auto& face = stack.faces[static_cast<std::size_t> (i)];
        planes[i] = face.isEmpty() ? stack.cores[static_cast<std::size_t> (i)].middle : face.neutralPlane (direction);
        matrix (i, i) += face.stretching (direction, direction);
    }

    const auto stiffnessOf = [&] (const Core& core)
    {
        return core.shearModulus == 0.0 ? core.shearModulus
                                        : core.shearModulus / (core.thickness * waveNumber * waveNumber);
    };

    for (Eigen::Index j = 0; j + 1 < count; ++j)
    {
        const auto stiffness = stiffnessOf (stack.cores[static_cast<std::size_t> (j)]);
        matrix.block<2, 2> (j, j) += stiffness * (Eigen::Matrix2cd() << 1, -1, -1, 1).finished();
        load.segment<2> (j) += stiffness * (planes[j + 1] - planes[j]) * Eigen::Vector2cd (-1, 1);
    }

    Slip slip { matrix.partialPivLu().solve (load), 0 };

    for (Eigen::Index j = 0; j + 1 < count; ++j)
    {
        const auto step = slip.stretches[j + 1] - slip.stretches[j] - (planes[j + 1] - planes[j]);
        slip.shear += stiffnessOf (stack.cores[static_cast<std::size_t> (j)]) * step * step;
    }

    return slip;
}

/** Adds a face that bends, and stretches by so much per curvature along x and y. */
void addFace (LayeredSection& section, const Face& face, std::complex<double> alongX, std::complex<double> alongY)
{
    if (face.isEmpty())
        return;

    const Eigen::Matrix3cd shift = face.coupling * face.stretching.inverse();
    const Eigen::Vector3cd stretches (alongX, alongY, (alongX + alongY) / 2.0);
    section.stiffness +=
        face.bending - shift * face.coupling + stretches.asDiagonal() * face.stretching * stretches.asDiagonal();
    section.momentPerVolt += face.moment - shift * face.force + stretches.asDiagonal() * face.force;
}
} // namespace

LayeredSection layeredSection (const std::vector<SectionLayer>& layers, double waveNumber)
{
    const auto stack = stackOf (layers);
    const auto alongX = slipAlong (stack, 0, waveNumber), alongY = slipAlong (stack, 1, waveNumber);
    LayeredSection section { Eigen::Matrix3cd::Zero(), Eigen::Vector3cd::Zero(), stack.massPerArea };

    for (std::size_t i = 0; i < stack.faces.size(); ++i)
        addFace (section, stack.faces[i], alongX.stretches[static_cast<Eigen::Index> (i)],
                 alongY.stretches[static_cast<Eigen::Index> (i)]);

    const auto both = std::sqrt (alongX.shear * alongY.shear);
    section.stiffness.topLeftCorner<2, 2>() +=
        (Eigen::Matrix2cd() << alongX.shear, both, both, alongY.shear).finished();
    return section;
}

SectionLayer elasticLayer (const ElasticMaterial& material, double thickness)
{
    return { thickness, material.density, planeStress (material).cast<std::complex<double>>() };
}

SectionLayer softLayer (const ViscoelasticMaterial& material, double thickness, double angularFrequency)
{
    const auto shear = shearModulusAt (material, angularFrequency);
    const auto ratio = material.poissonRatio;
    const auto modulus = 2 * (1 + ratio);
    const Eigen::Matrix3d unit = planeStress ({ modulus, modulus, 1, ratio, material.density });
    return { thickness, material.density, shear * unit, Eigen::Vector3d::Zero(), shear };
}

SectionLayer piezoelectricLayer (const PiezoelectricMaterial& material, double thickness, double voltage, double angle)
{
    const auto fibres = material.fibres.value_or (
        FibreComposite { material.youngsModulus, material.shearModulus(), material.d31, thickness });
    const auto stiffness = planeStress ({ material.youngsModulus, fibres.youngsModulus2, fibres.shearModulus,
                                          material.poissonRatio, material.density });
    const auto turn = strainsAlong (angle);
    const Eigen::Vector3d stress =
        stiffness * Eigen::Vector3d (material.d31, fibres.d32, 0) * (voltage / fibres.electrodeDistance);
    return { thickness, material.density, (turn.transpose() * stiffness * turn).cast<std::complex<double>>(),
             turn.transpose() * stress };
}

std::vector<SectionLayer> plateLayers (const StructureCommon& common)
{
    if (common.layers.empty())
        return { elasticLayer (common.material, common.thickness) };

    std::vector<SectionLayer> layers;

    for (const auto& layer : common.layers)
    {
        const auto* soft = std::get_if<ViscoelasticMaterial> (&layer.material);
        layers.push_back (soft ? softLayer (*soft, layer.thickness, common.reference.angularFrequency)
                               : elasticLayer (std::get<ElasticMaterial> (layer.material), layer.thickness));
    }

    return layers;
}

namespace
{
std::vector<SectionLayer> gluedLayers (const CeramicDescription& ceramic, double voltage, double angle,
                                       bool withCeramic)
{
    std::vector<SectionLayer> layers;

    if (ceramic.carrier)
        layers.push_back (elasticLayer (ceramic.carrier->material, ceramic.carrier->thickness));

    if (withCeramic)
        layers.push_back (piezoelectricLayer (ceramic.material, ceramic.thickness, voltage, angle));

    return layers;
}

/** Glue and what is glued to one side, from the plate outwards. */
std::vector<SectionLayer> mounted (const CeramicDescription& ceramic, double voltage, double angle,
                                   const StackParts& parts)
{
    std::vector<SectionLayer> layers;

    if (ceramic.glue)
        layers.push_back (elasticLayer (ceramic.glue->material, ceramic.glue->thickness));

    if (! parts.isBonded)
    {
        SectionLayer gap; // Of no thickness, it hands no shear over.
        gap.softShearModulus = 0;
        layers.push_back (gap);
    }

    const auto glued = gluedLayers (ceramic, voltage, angle, parts.withCeramic);
    layers.insert (layers.end(), glued.begin(), glued.end());
    return layers;
}
} // namespace

std::vector<SectionLayer> gluedLayers (const CeramicDescription& ceramic, bool withCeramic)
{
    return gluedLayers (ceramic, 0, 0, withCeramic);
}

std::vector<SectionLayer> stackLayers (const StructureCommon& common, const CeramicDescription& ceramic, double angle,
                                       const StackParts& parts)
{
    const auto isPair = ceramic.mounting == CeramicMounting::bothSides;
    const auto voltage = ceramic.polarity * (isPair && ceramic.wiring == CeramicWiring::series ? 0.5 : 1.0);
    auto layers = plateLayers (common);
    const auto above = mounted (ceramic, voltage, angle, parts);
    std::copy (above.begin(), above.end(), std::back_inserter (layers));

    // The one below strains the other way.
    if (isPair)
    {
        const auto below = mounted (ceramic, -voltage, angle, parts);
        layers.insert (layers.begin(), below.rbegin(), below.rend());
    }

    return layers;
}

LayeredSection sectionWith (const StructureCommon& common, const CeramicDescription& ceramic, double angle,
                            const StackParts& parts)
{
    return layeredSection (stackLayers (common, ceramic, angle, parts), common.reference.waveNumber);
}

PlateSection alongAxes (const LayeredSection& section)
{
    const Eigen::Matrix3d stiffness = section.stiffness.real();
    const Eigen::Vector3d moment = section.momentPerVolt.real();
    return { section.massPerArea, stiffness (0, 0), stiffness (1, 1), stiffness (0, 1),
             stiffness (2, 2),    moment[0],        moment[1] };
}

LayeredSection bareStack (const StructureCommon& common)
{
    return layeredSection (plateLayers (common), common.reference.waveNumber);
}

PlateSection bareSection (const StructureCommon& common)
{
    return alongAxes (bareStack (common));
}

PlateSection ceramicSection (const StructureCommon& common, const CeramicDescription& ceramic)
{
    return alongAxes (sectionWith (common, ceramic, 0));
}
} // namespace antinode
