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
  cellDiameter     ///< largest distance of two corners, the cell diameter of FEniCS
};

/// Of an element of these nodes at positions x (3×N, m), m.
double characteristicLength(const ElementInfo& element, NodeVectorsView x, std::span<const std::int32_t> nodes,
                            CharacteristicLength kind);

/// omega = 2 s / L, s the speed of a pressure wave at rest, L the characteristic length of the current shape (Fierz
/// 2013, eq. 3.18, 3.27 and 3.28): [block][element], rad²/s², at positions x (3×N, m). An estimate. Faces are those of
/// the corners; the middle nodes of quadratic elements count in the volume and as neighbours on an edge.
std::vector<std::vector<double>> pressureWave(const Body& body, NodeVectorsView x, CharacteristicLength length);

}  // namespace ringwatch
