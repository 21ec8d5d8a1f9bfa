#include <ringwatch/handlers/local_time_stepping/level_watch.h>

namespace ringwatch {

LevelWatch::LevelWatch(const Body& body, const ElementFlags& elements, const Eigen::VectorXd& mass, double lambda,
                       int substeps)
    : nodes_(nodesOf(body, elements)), lambda_(lambda), substeps_(substeps) {
  part_ = std::make_unique<Body>(bodyOf(body, elements, nodes_, mass(nodes_)));
  bound_ = std::make_unique<MovedBound>(*part_);
}

bool LevelWatch::certifies(const NodeVectors& x) {
  x_ = x(Eigen::all, nodes_);
  return bound_->certify(x_, lambda_);
}

}  // namespace ringwatch
