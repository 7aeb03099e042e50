#include "StandardGraph.h"

namespace antinode
{
namespace
{
/** Gains, limiter, plate and lags behind what gives voltages. */
void addOutputs (StandardGraph& standard, int voltages, const std::shared_ptr<const ModalModel>& model,
                 const Eigen::MatrixXd& probeShapes, const InsertNodes& insert)
{
    auto& graph = standard.graph;
    const auto ceramics = static_cast<int> (model->actuators());
    standard.gains = graph.add (std::make_unique<ChannelGainNode> (ceramics), voltages);
    const auto last = insert (graph, GraphPlace::afterGains, standard.gains);
    standard.limiter = graph.add (std::make_unique<LimiterNode> (voltageLimits (*model)), last);
    insert (graph, GraphPlace::afterLimiter, standard.limiter);
    standard.plate = graph.add (std::make_unique<PlateNode> (model, probeShapes), standard.limiter);
    graph.setOutputs ({ standard.limiter, standard.plate });
    standard.lags = addLagOutputs (graph, model, standard.limiter);

    if (standard.lags)
        graph.setOutputs ({ standard.limiter, standard.plate, standard.lags.limiter });
}

int insertNothing (NodeGraph&, GraphPlace, int last)
{
    return last;
}
} // namespace

StandardGraph standardGraph (const std::shared_ptr<const ModalModel>& model, const PlayerSettings& settings,
                             const Eigen::MatrixXd& probeShapes)
{
    StandardGraph standard;
    const auto ceramics = static_cast<int> (model->actuators());
    standard.player = standard.graph.add (std::make_unique<PlayerNode> (ceramics, settings), NodeGraph::noSource);
    addOutputs (standard, standard.player, model, probeShapes, insertNothing);
    return standard;
}

StandardGraph openGraph (const std::shared_ptr<const ModalModel>& model, const PlayerSettings& settings,
                         const Eigen::MatrixXd& probeShapes, const InsertNodes& insert)
{
    const auto inserting = insert ? insert : InsertNodes (insertNothing);
    const auto ceramics = static_cast<int> (model->actuators());
    StandardGraph standard;
    auto& graph = standard.graph;
    auto forceNode = std::make_unique<ForceNode> (ceramics, settings);
    const auto& forces = *forceNode;
    standard.player = graph.add (std::move (forceNode), NodeGraph::noSource);
    auto last = inserting (graph, GraphPlace::afterForces, standard.player);
    last = graph.add (std::make_unique<AllocationNode> (forces, ceramics), last);
    last = inserting (graph, GraphPlace::afterAllocation, last);
    addOutputs (standard, last, model, probeShapes, inserting);
    return standard;
}
} // namespace antinode
