#include "StandardGraph.h"

namespace antinode
{
StandardGraph standardGraph (const std::shared_ptr<const ModalModel>& model, const PlayerSettings& settings,
                             const Eigen::MatrixXd& probeShapes)
{
    const auto ceramics = static_cast<int> (model->actuators());
    Eigen::VectorXd limits (ceramics);

    for (Eigen::Index i = 0; i < limits.size(); ++i)
        limits[i] = model->ceramics[static_cast<std::size_t> (i)].voltageLimit;

    StandardGraph standard;
    auto& graph = standard.graph;
    standard.player = graph.add (std::make_unique<PlayerNode> (ceramics, settings), NodeGraph::noSource);
    standard.gains = graph.add (std::make_unique<ChannelGainNode> (ceramics), standard.player);
    standard.limiter = graph.add (std::make_unique<LimiterNode> (limits), standard.gains);
    standard.plate = graph.add (std::make_unique<PlateNode> (model, probeShapes), standard.limiter);
    graph.setOutputs ({ standard.limiter, standard.plate });
    return standard;
}
} // namespace antinode
