#pragma once
#include <vector>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// Strain energy of each element of a body at positions x (3×N, m), J, energies[block][element]; the same bits for any
/// number of threads. With those of springs and contact (DiscreteForces::energy) they add up to Body::energy.
std::vector<std::vector<double>> strainEnergyOfElements(const Body& body, NodeVectorsView x);

/// Volume of each element at rest by its quadrature rule, m³, elements in the order of blocks.
std::vector<double> volumeOfElements(const Body& body);

/// Lumped mass that some elements give to each node, kg, N numbers (Body::elementLumpedMass). Those of all elements are
/// the mass of the body where none was added to its nodes.
Eigen::VectorXd lumpedMassOfElements(const Body& body, const std::vector<ElementRef>& elements);

}  // namespace ringwatch
