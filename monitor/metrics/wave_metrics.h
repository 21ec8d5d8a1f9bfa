#pragma once
#include <span>
#include <vector>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// What a pressure wave has to cross in an element, m.
enum class CharacteristicLength {
  usual,           ///< 3 V / max A for tetrahedra (their least height), V / max A else (Fierz 2013, eq. 3.28)
  minHeight,       ///< least over the faces of the largest distance of a corner from the face's mean plane
  volumeOverArea,  ///< V / max A (Miller et al. 2006)
  inRadius,        ///< 3 V / Σ A, the radius of the inscribed sphere where one touches all faces
  shortestEdge,    ///< shortest distance of neighbouring nodes on an edge (Debunne et al. 2001; Fierz 2013, eq. 3.18)
  cellDiameter,    ///< largest distance of two corners, the cell diameter of FEniCS
  /// 0.7669 k V / max A, whose crossing is the step that CalculiX 2.20 prints for *DYNAMIC, EXPLICIT: its safety factor
  /// 0.8 times 0.98 times the 0.9782 of its default ALPHA = -0.05. V is det J at the middle times the reference volume;
  /// k is 1 for hexahedra, 1/2 for wedges, 1/3 for tetrahedra and for pyramids, which CalculiX has not, and 0.3 of that
  /// for quadratic elements.
  calculix
};

/// Of an element of these nodes at positions x (3×N, m), m.
double characteristicLength(const ElementInfo& element, NodeVectorsView x, std::span<const std::int32_t> nodes,
                            CharacteristicLength kind);

/// omega = 2 s / L, s the speed of a pressure wave at rest, L the characteristic length of the current shape (Fierz
/// 2013, eq. 3.18, 3.27 and 3.28): [block][element], rad²/s², at positions x (3×N, m). An estimate. Faces are those of
/// the corners; the middle nodes of quadratic elements count in the volume and as neighbours on an edge.
std::vector<std::vector<double>> pressureWave(const Body& body, NodeVectorsView x, CharacteristicLength length);

/// The nodal step of Radioss (/DT/NODA; Radioss user guide, "Nodal Time Step"), h = √(2 m_i / k_i) at node i, where k_i
/// takes half of each element's omega_e² times the mass that the element gives to the node: omega_i² = Σ_e m_ei
/// omega_e² / m_i with the omega_e of pressureWave and the usual length. Each element has the highest of its nodes:
/// [block][element], rad²/s², at positions x (3×N, m). An estimate.
std::vector<std::vector<double>> pressureWaveAtNodes(const Body& body, NodeVectorsView x);

/// omega² = (λ + 2μ) / V Σ_a |B_a|² / m_a with B_a = ∫ ∇N_a dV over the current shape, of volume V, the moduli at rest
/// and the element's own lumped masses m_a: the frequency of an element whose stiffness is that of its mean divergence
/// alone, (λ + 2μ) B Bᵀ / V. Flanagan & Belytschko 1984 estimate elements with one quadrature point so, and Abaqus'
/// element-by-element steps are said to follow the dilatational mode. [block][element], rad²/s², at positions x (3×N,
/// m). An estimate: hourglass and shear modes of elements with more points can be higher.
std::vector<std::vector<double>> dilatationalMode(const Body& body, NodeVectorsView x);

}  // namespace ringwatch
