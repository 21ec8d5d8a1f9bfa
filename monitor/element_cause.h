#pragma once
#include <string>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// Why an element allows only a small step at positions x (3×N, m), in a few words for people: its largest departure
/// from rest ("inverted, det F = -0.31", "stretched 1.6", "compressed to 0.62", from 5 % on), and its shape at rest
/// where that is a bad one ("needle, 0.4° dihedral", "small"); "well shaped, unstrained" when it is neither. Quadratic
/// elements are judged by their corners. "not finite" for positions that are not.
std::string elementCause(const Body& body, const NodeVectors& x, ElementRef element);

}  // namespace ringwatch
