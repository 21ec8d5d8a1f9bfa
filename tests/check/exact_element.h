#pragma once
#include <check/proof.h>
#include <check/tangent.h>
#include <ringwatch/body/body.h>
#include <ringwatch/monitor/certificate_file.h>
#include <tests/support/body_cases.h>

namespace ringwatch::test {

/// Those of allBodyCases whose law and rule the checker knows.
inline std::vector<BodyCase> certifiableBodyCases() {
  std::vector<BodyCase> cases = allBodyCases();
  std::erase_if(cases, [](const BodyCase& c) { return !lawHasCertificates(materialOf(c)) || c.rule->uniformStrain; });
  return cases;
}

/// What check/ knows of the elements of a block.
inline check::Kind kindOf(const ElementBlock& block) {
  const Lame constants = block.material().restModuli();
  const LameShares& shares = block.rule().shares;
  check::Kind kind;
  kind.element = block.element().name;
  kind.law = block.material().lawName();
  kind.lambda = constants.lambda;
  kind.mu = constants.mu;
  kind.pointLambda = shares.pointLambda;
  kind.pointMu = shares.pointMu;
  kind.meanLambda = shares.meanLambda;
  kind.meanMu = shares.meanMu;
  for (const QuadraturePoint& point : block.rule().points)
    kind.points.push_back({point.xi[0], point.xi[1], point.xi[2], point.weight});
  return kind;
}

/// The tangent of element 0 of a body of one element, whose nodes are in their own order, in balls; false where it
/// cannot be enclosed.
inline bool exactTangent(const Body& body, NodeVectorsView x, check::Square& K) {
  double volume = 0;
  const NodeVectors& X = body.mesh().X;
  return check::elementTangent(kindOf(*body.blocks()[0]), X.data(), x.data(), K, volume);
}

/// Whether a symmetric matrix is proven positive definite.
inline bool definite(const check::Square& A) {
  check::Rows rows(A.size);
  for (int i = 0; i < A.size; ++i)
    for (int j = 0; j <= i; ++j) rows[i].push_back(A(i, j));
  return check::positiveDefinite(rows);
}

/// What the checker says of lambda_max(M⁻¹K) < sigma, by a factorisation of the whole body in balls.
inline check::Verdict exactlyBelow(const Body& body, const NodeVectors& x, double sigma) {
  return check::verify(makeFactoredCertificate(body, x, {{sigma}, {0}, {}}).bytes);
}

}  // namespace ringwatch::test
