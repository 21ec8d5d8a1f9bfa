#include "tangent.h"

#include <algorithm>
#include <utility>

namespace check {
namespace {

using Row = std::array<Ball, 3>;

/// Corners of [-1, 1]³ and, from 8 on, the middles of its edges, in VTK's order.
constexpr int cube[20][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1},  {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1},
                             {-1, 1, 1},   {0, -1, -1}, {1, 0, -1},  {0, 1, -1},  {-1, 0, -1}, {0, -1, 1}, {1, 0, 1},
                             {0, 1, 1},    {-1, 0, 1},  {-1, -1, 0}, {1, -1, 0},  {1, 1, 0},   {-1, 1, 0}};
constexpr int tetEdge[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};

/// ∂N_a/∂ξ_j at a point.
std::vector<Row> shapeGradients(const std::string& element, const double* point) {
  const Ball xi[3] = {point[0], point[1], point[2]};
  std::vector<Row> dN(nodesOf(element));
  if (element == "hex8" || element == "hex20") {
    for (std::size_t a = 0; a < dN.size(); ++a) {
      // A product of a factor for each direction, 1 + ξ ξ_a, or 1 - ξ² along the edge of a middle.
      Ball f[3], df[3], sum = -2.0;
      for (int j = 0; j < 3; ++j) {
        const double at = cube[a][j];
        f[j] = at == 0 ? Ball(1.0) - xi[j] * xi[j] : Ball(1.0) + Ball(at) * xi[j];
        df[j] = at == 0 ? Ball(-2.0) * xi[j] : Ball(at);
        sum += Ball(at) * xi[j];
      }
      for (int j = 0; j < 3; ++j) {
        const Ball others = f[(j + 1) % 3] * f[(j + 2) % 3];
        if (element == "hex8")
          dN[a][j] = Ball(0.125) * others * df[j];
        else if (a < 8)  // f0 f1 f2 (ξ·ξ_a - 2)/8
          dN[a][j] = Ball(0.125) * others * (df[j] * sum + f[j] * Ball(cube[a][j]));
        else
          dN[a][j] = Ball(0.25) * others * df[j];
      }
    }
    return dN;
  }
  if (element == "pyramid5") {  // N_a = (w + x x_a)(w + y y_a)/(4 w), w = 1 - z; N_4 = z
    const Ball w = Ball(1.0) - xi[2];
    for (std::size_t a = 0; a < 4; ++a) {
      const Ball xa(cube[a][0]), ya(cube[a][1]), u = w + xa * xi[0], v = w + ya * xi[1], four = Ball(4.0) * w;
      dN[a] = {xa * v / four, ya * u / four, (u * v / w - u - v) / four};
    }
    dN[4] = {0.0, 0.0, 1.0};
    return dN;
  }
  // Volume coordinates of a tetrahedron, or area coordinates of a wedge's triangle.
  const bool wedge = element == "wedge6";
  const Ball L[4] = {Ball(1.0) - xi[0] - xi[1] - (wedge ? Ball(0.0) : xi[2]), xi[0], xi[1], xi[2]};
  const auto slope = [](int a, int j) { return Ball(a == 0 ? -1.0 : a == j + 1 ? 1.0 : 0.0); };
  if (wedge) {
    for (int a = 0; a < 3; ++a)
      for (int side = 0; side < 2; ++side) {
        const Ball sign = side == 0 ? -1.0 : 1.0, height = Ball(0.5) * (Ball(1.0) + sign * xi[2]);
        dN[a + 3 * side] = {slope(a, 0) * height, slope(a, 1) * height, Ball(0.5) * sign * L[a]};
      }
    return dN;
  }
  for (int j = 0; j < 3; ++j) {
    for (int a = 0; a < 4; ++a)
      dN[a][j] = element == "tet4" ? slope(a, j) : (Ball(4.0) * L[a] - Ball(1.0)) * slope(a, j);
    for (std::size_t e = 4; e < dN.size(); ++e) {
      const int a = tetEdge[e - 4][0], b = tetEdge[e - 4][1];
      dN[e][j] = Ball(4.0) * (slope(a, j) * L[b] + L[a] * slope(b, j));
    }
  }
  return dN;
}

Matrix product(const Matrix& A, const Matrix& B) {
  Matrix C;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) C[i][j].addProduct(A[i][k], B[k][j]);
  return C;
}
Matrix transpose(const Matrix& A) {
  Matrix T;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) T[i][j] = A[j][i];
  return T;
}
Matrix cofactor(const Matrix& A, Ball& determinant) {
  Matrix cof;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int r = (i + 1) % 3, s = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
      cof[i][j] = A[r][c] * A[s][d] - A[r][d] * A[s][c];
    }
  determinant = A[0][0] * cof[0][0] + A[0][1] * cof[0][1] + A[0][2] * cof[0][2];
  return cof;
}
Matrix inverse(const Matrix& A, Ball& determinant) {
  Matrix adjugate = transpose(cofactor(A, determinant));
  for (Row& row : adjugate)
    for (Ball& entry : row) entry = entry / determinant;
  return adjugate;
}
/// Σ_a u_a ⊗ g_a of differences to the first node, which doubles' differences in balls are exactly.
Matrix gradient(const double* u, const std::vector<Row>& g) {
  Matrix D;
  for (std::size_t a = 1; a < g.size(); ++a)
    for (int i = 0; i < 3; ++i) {
      const Ball edge = Ball(u[3 * a + static_cast<std::size_t>(i)]) - Ball(u[i]);
      for (int j = 0; j < 3; ++j) D[i][j].addProduct(edge, g[a][j]);
    }
  return D;
}

/// ε_ijk
int permutation(int i, int j, int k) { return (i - j) * (j - k) * (k - i) / 2; }

/// The rotation of a quaternion of any length.
Matrix rotationOf(const std::array<Ball, 4>& q) {
  const Ball length2 = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  Matrix R;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Ball entry = Ball(2.0) * q[i + 1] * q[j + 1];
      if (i == j) entry += Ball(2.0) * q[0] * q[0] - length2;
      for (int k = 0; k < 3; ++k)
        if (permutation(i, j, k) != 0) entry += Ball(-2.0 * permutation(i, j, k)) * q[0] * q[k + 1];
      R[i][j] = entry / length2;
    }
  return R;
}

/// The rotation R closest to F, U = sym(RᵀF) and (tr(U) I - U)⁻¹, in balls. A guess Q from the top eigenvector of
/// Davenport's 4×4 matrix, by squaring it again and again, and a proof: where all sums of two eigenvalues of
/// U = sym(QᵀF) are at least g > 0, Q is the rotation closest to Q U, and |R - Q| <= 2 δ/(g - √2 δ), δ = |F - Q U|.
bool closestRotation(const Matrix& F, Matrix& R, Matrix& U, Matrix& spin) {
  Square A(4);
  Ball norm2, determinant;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      norm2.addProduct(F[i][j], F[i][j]);
      A(0, 0) += i == j ? F[i][j] : Ball(0.0);
      A(i + 1, j + 1) = F[i][j] + F[j][i];
      for (int k = 0; k < 3; ++k)
        if (permutation(i, j, k) != 0) A(0, k + 1).addProduct(Ball(permutation(j, i, k)), F[i][j]);
    }
  for (int k = 1; k < 4; ++k) {
    A(k, k) = A(k, k) - A(0, 0);
    A(k, 0) = A(0, k);
  }
  for (int k = 0; k < 4; ++k) A(k, k) += Ball(2.0) * root(norm2);
  for (int turn = 0; turn < 24; ++turn) {
    Square B(4);
    const Ball trace = A(0, 0) + A(1, 1) + A(2, 2) + A(3, 3);
    for (int i = 0; i < 16; ++i) {
      for (int k = 0; k < 4; ++k) B(i / 4, i % 4).addProduct(A(i / 4, k), A(k, i % 4));
      B(i / 4, i % 4) = (B(i / 4, i % 4) / trace / trace).middle();
    }
    A = B;
  }
  int column = 0;
  for (int k = 1; k < 4; ++k)
    if ((A(k, k) - A(column, column)).positive()) column = k;
  R = rotationOf({A(0, column), A(1, column), A(2, column), A(3, column)});
  Ball distance, g;
  for (int pass = 0; pass < 2; ++pass) {  // of the guess, and of the ball around it
    const Matrix M = product(transpose(R), F);
    Ball skew2, spin2;
    Rows sums(3);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        U[i][j] = Ball(0.5) * (M[i][j] + M[j][i]);
        const Ball skew = Ball(0.5) * (M[i][j] - M[j][i]);
        skew2.addProduct(skew, skew);
        spin[i][j] = (i == j ? M[0][0] + M[1][1] + M[2][2] : Ball(0.0)) - U[i][j];
        if (j <= i) sums[i].push_back(spin[i][j]);
      }
    if (!positiveDefinite(sums)) return false;
    spin = inverse(spin, determinant);
    if (pass == 1) return true;
    for (const Row& row : spin)
      for (const Ball& entry : row) spin2.addProduct(entry, entry);
    distance = root(skew2.size());
    g = Ball(1.0) / root(spin2) - Ball(1.5) * distance;
    if (!g.positive()) return false;
    for (Row& row : R)
      for (Ball& entry : row) entry = entry.widened(Ball(2.0) * distance / g);
  }
  return false;
}

/// ∂P_iJ/∂F_kL at [3 i + J][3 k + L].
bool modulus(const std::string& law, const Ball& lambda, const Ball& mu, const Matrix& F, Square& C) {
  Matrix A, S, U, spin;  // C = x δ_ik δ_JL + λ A_iJ A_kL + y A_iL A_kJ + …
  Ball x = mu, y = mu, t;
  Ball volume, soften, stiff = lambda;
  const bool stvk = law == "stvk", stable = law == "stable-neo-hookean";
  if (stvk) {
    A = F;
    S = product(transpose(F), F);
    for (int i = 0; i < 3; ++i) S[i][i] = S[i][i] - Ball(1.0);
    const Ball pressure = Ball(0.5) * lambda * (S[0][0] + S[1][1] + S[2][2]);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) S[i][j] = mu * S[i][j] + (i == j ? pressure : Ball(0.0));
    U = product(F, transpose(F));
    x = 0.0;
  } else if (law == "linear") {
    for (int i = 0; i < 3; ++i) A[i][i] = 1.0;
  } else if (law == "neo-hookean") {
    Ball J;
    A = transpose(inverse(F, J));
    if (!J.positive()) return false;
    y = mu - lambda * logarithm(J);
  } else if (stable) {
    Ball norm2;
    A = cofactor(F, volume);
    for (const Row& row : F)
      for (const Ball& entry : row) norm2.addProduct(entry, entry);
    const Ball m = Ball(4.0) * mu / Ball(3.0), q = norm2 + Ball(1.0);
    x = m * norm2 / q;
    soften = Ball(2.0) * m / q / q;
    stiff = lambda + Ball(5.0) * mu / Ball(6.0);
    t = stiff * (volume - Ball(1.0)) - mu;
    y = 0.0;
  } else {  // corotational
    if (!closestRotation(F, A, U, spin)) return false;
    t = lambda * (U[0][0] + U[1][1] + U[2][2] - Ball(3.0)) - Ball(2.0) * mu;
    x = Ball(2.0) * mu;
    y = 0.0;
  }
  for (int i = 0; i < 3; ++i)
    for (int J = 0; J < 3; ++J)
      for (int k = 0; k < 3; ++k)
        for (int L = 0; L < 3; ++L) {
          Ball& c = C(3 * i + J, 3 * k + L) = stiff * A[i][J] * A[k][L] + y * A[i][L] * A[k][J];
          if (i == k && J == L) c += x;
          if (stvk && i == k) c += S[J][L];
          if (stvk && J == L) c.addProduct(mu, U[i][k]);
          if (!stable) continue;
          c.addProduct(soften * F[i][J], F[k][L]);
          if (i != k && J != L)  // ∂cof_iJ/∂F_kL = ε_ikn ε_JLQ F_nQ
            c.addProduct(t * Ball(permutation(i, k, 3 - i - k) * permutation(J, L, 3 - J - L)),
                         F[3 - i - k][3 - J - L]);
        }
  if (law != "corotational") return true;
  // t ∂R/∂F: dR = R [w]×, w = (tr(U) I - U)⁻¹ axial(RᵀdF - dFᵀR).
  Matrix cross[3];  // [n][i][J] = Σ_p R_ip ε_pnJ
  for (int entry = 0; entry < 27; ++entry)
    for (int p = 0; p < 3; ++p)
      if (const int n = entry / 9, i = entry / 3 % 3, J = entry % 3, sign = permutation(p, n, J); sign != 0)
        cross[n][i][J].addProduct(Ball(sign), A[i][p]);
  for (int m = 0; m < 3; ++m)
    for (int n = 0; n < 3; ++n) {
      const Ball factor = t * spin[m][n];
      for (int r = 0; r < 9; ++r)
        for (int s = 0; s < 9; ++s) C(r, s).addProduct(factor * cross[m][r / 3][r % 3], cross[n][s / 3][s % 3]);
    }
  return true;
}

/// K += w g_a C g_b
void addTo(Square& K, const Square& C, const Ball& weight, const std::vector<Row>& g) {
  const int n = static_cast<int>(g.size());
  for (int b = 0; b < n; ++b) {
    Ball Cg[9][3];
    for (int r = 0; r < 9; ++r)
      for (int k = 0; k < 3; ++k) {
        for (int L = 0; L < 3; ++L) Cg[r][k].addProduct(C(r, 3 * k + L), g[b][L]);
        Cg[r][k] = weight * Cg[r][k];
      }
    for (int a = 0; a <= b; ++a)
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
          for (int J = 0; J < 3; ++J) K(3 * a + i, 3 * b + k).addProduct(g[a][J], Cg[3 * i + J][k]);
  }
}

}  // namespace

int nodesOf(const std::string& element) {
  const std::pair<const char*, int> known[] = {{"tet4", 4},   {"tet10", 10}, {"hex8", 8},
                                               {"hex20", 20}, {"wedge6", 6}, {"pyramid5", 5}};
  for (const auto& [name, nodes] : known)
    if (element == name) return nodes;
  return 0;
}

bool knowsLaw(const std::string& law) {
  return law == "stvk" || law == "linear" || law == "neo-hookean" || law == "corotational" ||
         law == "stable-neo-hookean";
}

bool elementTangent(const Kind& kind, const double* X, const double* x, Square& K, double& restVolume) {
  K = Square(3 * nodesOf(kind.element));
  std::vector<Row> mean(nodesOf(kind.element));
  Ball volume;
  Square C(9);
  for (const auto& point : kind.points) {
    std::vector<Row> g = shapeGradients(kind.element, point.data());
    Ball J;
    const Matrix inverseJacobian = inverse(gradient(X, g), J);
    if (!J.positive()) return false;
    for (Row& own : g) {
      Row spatial;
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k) spatial[j].addProduct(own[k], inverseJacobian[k][j]);
      own = spatial;
    }
    const Ball weight = J * Ball(point[3]);
    volume += weight;
    for (std::size_t a = 0; a < g.size(); ++a)
      for (int j = 0; j < 3; ++j) mean[a][j].addProduct(weight, g[a][j]);
    if (!modulus(kind.law, Ball(kind.pointLambda) * Ball(kind.lambda), Ball(kind.pointMu) * Ball(kind.mu),
                 gradient(x, g), C))
      return false;
    addTo(K, C, weight, g);
  }
  if (kind.meanLambda != 0 || kind.meanMu != 0) {
    for (Row& own : mean)
      for (Ball& entry : own) entry = entry / volume;
    if (!modulus(kind.law, Ball(kind.meanLambda) * Ball(kind.lambda), Ball(kind.meanMu) * Ball(kind.mu),
                 gradient(x, mean), C))
      return false;
    addTo(K, C, volume, mean);
  }
  for (int i = 0; i < K.size; ++i)
    for (int j = 0; j < i; ++j) K(i, j) = K(j, i);
  restVolume = volume.rounded();
  return true;
}

bool positiveDefinite(Rows& A) {
  std::vector<Ball> rest(A.size());  // of each row of A - L Lᵀ: its diagonal less the sizes of all others
  for (std::size_t i = 0; i < A.size(); ++i) {
    const std::size_t first = i + 1 - A[i].size();
    const Ball spared = Ball(0x1p-54) * A[i].back();
    for (std::size_t j = first; j <= i; ++j) {
      const std::size_t other = j + 1 - A[j].size();
      Ball& own = A[i][j - first];
      for (std::size_t k = std::max(first, other); k < j; ++k) own.subtractProduct(A[i][k - first], A[j][k - other]);
      const Ball left = own, factor = j < i ? left / A[j].back() : root(left - spared);
      own = factor.middle();
      if (j == i && !own.positive()) return false;
      const Ball missed = left - own * A[j].back();
      rest[i] += j < i ? Ball(0.0) - missed.size() : missed;
      if (j < i) rest[j] += Ball(0.0) - missed.size();
    }
  }
  for (const Ball& row : rest)
    if (!row.positive()) return false;
  return true;
}

}  // namespace check
