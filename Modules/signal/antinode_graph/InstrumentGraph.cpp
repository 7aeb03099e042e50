#include "InstrumentGraph.h"

#include "InputNodes.h"
#include "OutputNodes.h"
#include "VoiceNode.h"

#include <utility>

namespace antinode
{
namespace
{
/** Puts an instrument together, node by node. */
struct InstrumentBuilder
{
    const std::shared_ptr<const ModalModel>& model;
    InstrumentNodes nodes;
    InstrumentGraph made = {};
    int ceramics = static_cast<int> (model->actuators());

    int add (std::unique_ptr<Node> node, int source) { return made.graph.add (std::move (node), source); }

    int inserted (GraphPlace place, int last)
    {
        return nodes.choice.isOpen && nodes.choice.insert ? nodes.choice.insert (made.graph, place, last) : last;
    }

    /** Foci alone; what is designed keeps slew rates by itself. */
    int addFoci()
    {
        if (! nodes.choice.isOpen)
            return made.voices = add (std::make_unique<PlayerNode> (ceramics, nodes.settings), NodeGraph::noSource);

        auto forceNode = std::make_unique<ForceNode> (ceramics, nodes.settings);
        const auto& forces = *forceNode;
        made.voices = add (std::move (forceNode), NodeGraph::noSource);
        const auto last = inserted (GraphPlace::afterForces, made.voices);
        return inserted (GraphPlace::afterAllocation, add (std::make_unique<AllocationNode> (forces, ceramics), last));
    }

    /** Tracks with foci on top. */
    int addTracks()
    {
        made.input = add (std::make_unique<InputNode> (nodes.filters->inputs()), NodeGraph::noSource);
        made.filters = add (std::move (nodes.filters), made.input);
        made.voices = add (std::make_unique<OverlaidFociNode> (ceramics, nodes.settings), made.filters);
        const auto slews = slewLimits (*model);
        return slews.maxCoeff() > 0 ? add (std::make_unique<SlewNode> (voltageLimits (*model), slews), made.voices)
                                    : made.voices;
    }

    void addOutputs (int voltages)
    {
        made.gains = add (std::make_unique<ChannelGainNode> (ceramics), voltages);
        made.limiter =
            add (std::make_unique<LimiterNode> (voltageLimits (*model)), inserted (GraphPlace::afterGains, made.gains));
        inserted (GraphPlace::afterLimiter, made.limiter);
        std::vector outputs { made.limiter };

        if (nodes.probeShapes.rows() > 0)
        {
            made.plate = add (std::make_unique<PlateNode> (model, nodes.probeShapes), made.limiter);
            outputs.push_back (made.plate);
        }

        made.lags = addLagOutputs (made.graph, model, made.limiter);

        if (made.lags)
            outputs.push_back (made.lags.limiter);

        made.graph.setOutputs (std::move (outputs));
    }
};
} // namespace

InstrumentGraph instrumentGraph (const std::shared_ptr<const ModalModel>& model, InstrumentNodes nodes)
{
    InstrumentBuilder builder { model, std::move (nodes) };
    builder.addOutputs (builder.nodes.filters != nullptr ? builder.addTracks() : builder.addFoci());
    return std::move (builder.made);
}
} // namespace antinode
