#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/app/scene/where_expression.h>
#include <ringwatch/base/options.h>
#include <ringwatch/body/body.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// A [material] of a scene and the elements that have it. SI units.
struct SceneMaterial {
  std::string model;
  Options parameters;                    // of the law
  double density = 0;                    // kg/m³
  DampingConstants damping;              // without bulk viscosity
  ElementRules rules;                    // of its elements
  std::optional<WhereExpression> where;  // holds at the centre of the element's nodes at rest
  std::string set;                       // or a named element set of the mesh; both empty: all elements
  std::string origin;                    // "scene.toml:12: [[material]]", for messages
  std::string selectionOrigin;           // "scene.toml:13: material.where"

  /// Whether elements of some kind have a rule of uniform strain.
  bool hasUniformStrain() const;
  bool ofAllElements() const { return !where && set.empty(); }
  /// The condition or the set as the scene has it; "all" without.
  std::string selection() const;
};

/// The laws of materials, each once: "stvk, neo-hookean".
std::string modelsText(const std::vector<SceneMaterial>& materials);

/// "--young and --density are required": the options that a material of a law lacks; "" where it lacks none.
std::string missingConstants(std::string_view model, const Options& parameters, const std::optional<double>& density);

/// What decides which material an element has.
enum class MaterialsBy {
  scene,  ///< the conditions and sets of the scene
  mesh    ///< the element sets of an earlier assignMaterials, in a mesh that was cut or read from a frame
};

using ElementNumbers = std::vector<std::vector<int>>;  ///< [block][element]
/// Splits the blocks of a mesh by numbers 0 to count - 1 of their elements, in the order of the blocks and of the
/// numbers; element sets follow, and element numbers for messages stay. Returns which block each was part of.
std::vector<std::size_t> splitMeshBlocks(Mesh& mesh, const ElementNumbers& numbers, int count);

/// Splits the blocks of a mesh so that each has one material, and names the elements of material N as the element set
/// "material.N", N counted from 0; element sets follow, and element numbers for messages stay. One material of all
/// elements changes nothing. Returns the materials of the blocks. Throws InputError for a selection without elements
/// and for elements without a material or with two.
std::vector<Material> assignMaterials(const std::vector<SceneMaterial>& materials, Mesh& mesh, MaterialsBy by);

/// The elements of a named element set, those with the numbers of "#3,7", or those at the centre of whose nodes at rest
/// a condition holds; all of them without either. Throws InputError "origin: …" for an unknown set and for a selection
/// without elements.
std::vector<ElementRef> selectedElements(const Mesh& mesh, const std::optional<WhereExpression>& where,
                                         const std::string& set, const std::string& origin);

/// The material of each block after assignMaterials.
std::vector<const SceneMaterial*> blockMaterials(const std::vector<SceneMaterial>& materials, const Mesh& mesh);

/// Which material the blocks of a mesh have after assignMaterials, counted from 0, and -1 without elements; empty where
/// there is but one.
std::vector<int> materialOfBlocks(const Mesh& mesh);

}  // namespace ringwatch
