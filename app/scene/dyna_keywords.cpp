#include <ringwatch/app/scene/dyna_keywords.h>

#include <algorithm>

#include <fmt/format.h>

namespace ringwatch {
namespace {

constexpr std::string_view notByRun = "is no load or motion that is taken";
constexpr std::string_view mayEnd = "may end a run, or change the body along it";
constexpr std::string_view noKind = "there are solid elements, point masses and rigid parts only";
constexpr std::string_view unlessSolid = "refused where a part of solid elements has one";

/// Every keyword that is known, without *MAT_ of laws that are taken. One that is not here is refused.
constexpr DeckKeywordRule dynaRules[] = {
    {DeckRule::mesh,
     "KEYWORD NODE ELEMENT_SOLID SET_NODE SET_NODE_LIST SET_NODE_LIST_GENERATE SET_PART SET_PART_LIST "
     "SET_PART_LIST_GENERATE SET_SOLID SET_SOLID_GENERATE INCLUDE END"},
    {DeckRule::taken,
     "PART SECTION_SOLID HOURGLASS ELEMENT_MASS CONTROL_TERMINATION CONTROL_TIMESTEP CONTROL_BULK_VISCOSITY "
     "CONTROL_HOURGLASS BOUNDARY_SPC_NODE BOUNDARY_SPC_SET BOUNDARY_PRESCRIBED_MOTION_NODE "
     "BOUNDARY_PRESCRIBED_MOTION_SET BOUNDARY_PRESCRIBED_MOTION_RIGID INITIAL_VELOCITY INITIAL_VELOCITY_NODE "
     "INITIAL_VELOCITY_GENERATION DAMPING_GLOBAL DAMPING_PART_STIFFNESS CONTACT_AUTOMATIC_SINGLE_SURFACE "
     "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE CONTACT_AUTOMATIC_NODES_TO_SURFACE CONTACT_SURFACE_TO_SURFACE "
     "CONTACT_NODES_TO_SURFACE RIGIDWALL_PLANAR SET_SEGMENT"},
    {DeckRule::takenInRun, "CONTROL_SOLUTION CONTROL_DYNAMIC_RELAXATION CONTROL_IMPLICIT_GENERAL",
     "refused where SOLN, IDRFLG or IMFLAG is not 0"},
    {DeckRule::taken, "ELEMENT_SHELL* ELEMENT_BEAM*",
     "they are no solids, and are left out with a note of their number"},
    {DeckRule::takenInRun,
     "DEFINE_CURVE LOAD_NODE_POINT LOAD_NODE_SET LOAD_BODY_X LOAD_BODY_Y LOAD_BODY_Z LOAD_SEGMENT "
     "LOAD_SEGMENT_SET"},
    // What the program does besides, and what other keywords refer to, whose references are refused.
    {DeckRule::harmless,
     "TITLE COMMENT CONTROL_ENERGY CONTROL_OUTPUT CONTROL_ACCURACY CONTROL_CPU CONTROL_PARALLEL CONTROL_MPP_* "
     "CONTROL_SHELL CONTROL_SOLID CONTROL_CONTACT CONTROL_RIGID CONTROL_STRUCTURED* CONTROL_UNITS CONTROL_CHECK_* "
     "CONTROL_DEBUG CONTROL_LSDA CONTROL_REQUIRE_REVISION CONTROL_SPH CONTROL_ALE DEFINE_BOX* DEFINE_COORDINATE_* "
     "DEFINE_CURVE_* DEFINE_FRICTION* DEFINE_FUNCTION* "
     "DEFINE_SD_ORIENTATION DEFINE_TABLE* DEFINE_TRANSFORMATION DEFINE_VECTOR* "
     "PARAMETER_DUPLICATION SET_SHELL* SET_BEAM* SET_TSHELL* SET_DISCRETE* SET_BOX* INTERFACE_COMPONENT* "
     "INTERFACE_SPRINGBACK*"},
    {DeckRule::harmless, "SECTION_* EOS_* MAT_*", unlessSolid},
    {DeckRule::output, "DATABASE_*"},
    {DeckRule::procedure, "CONTROL_IMPLICIT_* CONTROL_THERMAL_* FREQUENCY_DOMAIN_*",
     "is no explicit step, in which bodies move from rest"},
    {DeckRule::procedure, "CONTROL_ADAPTIVE* CONTROL_REMESHING* CONTROL_REFINE_*", "makes elements along a run"},
    {DeckRule::load, "LOAD_* BOUNDARY_PRESCRIBED_* RIGIDWALL_*", notByRun},
    {DeckRule::load, "TERMINATION_* SENSOR_* DEFORMABLE_TO_RIGID* RIGID_DEFORMABLE* DELETE_* CHANGE_* CASE*", mayEnd},
    {DeckRule::refused, "CONTROL_* DEFINE_*",
     "may change what the body is, or when parts of it act, and is not known here"},
    {DeckRule::refused, "INCLUDE_* PARAMETER*",
     "is not followed; write the lines and numbers that it stands for, or put the file in by *INCLUDE"},
    {DeckRule::refused, "NODE_* ELEMENT_SOLID_* ELEMENT_GENERATE* SET_* PART_* PERTURBATION_*",
     "makes or changes nodes, elements, sets or parts and is not supported; write them out with *NODE, *ELEMENT_SOLID, "
     "*SET_NODE_LIST and *PART"},
    {DeckRule::refused, "ELEMENT_* AIRBAG_* ALE_* SPH_* PARTICLE_* EM_* CESE_* ICFD_* CHEMISTRY_* FSI_* MESH_* LSO_*",
     noKind},
    {DeckRule::refused, "MAT_ADD_* MAT_THERMAL_*", "changes a law; laws are taken as they are"},
    {DeckRule::refused, "CONTACT_*",
     "of contact AUTOMATIC_SINGLE_SURFACE, SURFACE_TO_SURFACE and NODES_TO_SURFACE, the latter AUTOMATIC too, are "
     "taken"},
    {DeckRule::refused, "CONSTRAINED_*", noConstraint},
    {DeckRule::refused, "BOUNDARY_*", "of boundaries *BOUNDARY_SPC and *BOUNDARY_PRESCRIBED_MOTION are taken"},
    {DeckRule::refused, "INITIAL_STRESS_* INITIAL_STRAIN_* INITIAL_FOAM_* STRESS_INITIALIZATION", notAtRest},
    {DeckRule::refused, "INITIAL_*", "of initial conditions velocities are taken"},
    {DeckRule::refused, "DAMPING_*", "of damping *DAMPING_GLOBAL and *DAMPING_PART_STIFFNESS are taken"},
    {DeckRule::refused, "INTERFACE_* USER_* MODULE_* IGA_* RVE_*", elsewhere},
};

constexpr std::string_view collapsed =
    "LS-DYNA integrates it as a hexahedron that holds a node several times, unless *CONTROL_SOLID sorts it (ESORT)";
constexpr std::string_view byStrain =
    "LS-DYNA changes the strain for elements of poor shape; this is ELFORM 2, without that";
constexpr std::string_view modified =
    "LS-DYNA has a tetrahedron of pieces with masses of their own; the quadratic one stands for it, whose critical "
    "step differs";
constexpr std::string_view turning = "its nodes turn, and ours do not";
constexpr std::string_view fluid = "it is of fluids and moving meshes";
/// Sorted by the formulation (Keyword User's Manual, "*SECTION_SOLID").
constexpr DynaSolid dynaSolidRows[] = {
    {-2, "hex8", "selective", byStrain},
    {-2, "wedge6", "selective", collapsed},
    {-2, "pyramid5", "collapsed-2x2x2", collapsed},
    {-2, "tet4", "gauss-1", collapsed},
    {-1, "hex8", "selective", byStrain},
    {-1, "wedge6", "selective", collapsed},
    {-1, "pyramid5", "collapsed-2x2x2", collapsed},
    {-1, "tet4", "gauss-1", collapsed},
    {1, "hex8", "uniform-strain"},
    {1, "wedge6", "fierz2013", collapsed},
    {1, "pyramid5", "collapsed-2x2x2", collapsed},
    {1, "tet4", "gauss-1", collapsed},
    {2, "hex8", "selective"},
    {2, "wedge6", "selective", collapsed},
    {2, "pyramid5", "collapsed-2x2x2", collapsed},
    {2, "tet4", "gauss-1", collapsed},
    {3, "", "", turning},
    {4, "", "", turning},
    {5, "", "", fluid},
    {6, "", "", fluid},
    {7, "", "", fluid},
    {10, "tet4", "gauss-1"},
    {11, "", "", fluid},
    {12, "", "", fluid},
    {13, "tet4", "gauss-1",
     "LS-DYNA averages the pressure at nodes, so that nearly incompressible bodies do not lock; here each element has "
     "its own, which is stiffer"},
    {15, "wedge6", "fierz2013"},
    {16, "tet10", "keast-4"},
    {17, "tet10", "keast-4", modified},
};

constexpr std::string_view ofRates =
    "a law of rates there, and here linear elasticity in a frame that turns with the element; they agree at small "
    "strain";
constexpr std::string_view ofVolume =
    "the energy of volume here is bulk/2 (J - 1)^2 with the bulk modulus of PR; they agree where volume hardly changes";
constexpr DynaLawEntry dynaLaws[] = {
    {"ELASTIC 001 1", DynaLaw::elastic, "corotational", ofRates, 1},
    {"BLATZ-KO_RUBBER 007 7", DynaLaw::blatzKo, "neo-hookean",
     "Poisson's ratio is 0.463, as there; the energy of volume here is lambda/2 (ln J)^2, which agrees to the second "
     "order of ln J",
     1},
    {"MOONEY-RIVLIN_RUBBER 027 27", DynaLaw::mooneyRivlin, "mooney-rivlin", ofVolume, 2},
    {"HYPERELASTIC_RUBBER 077_H 77_H", DynaLaw::hyperelastic, "mooney-rivlin, or yeoh", ""},
    {"OGDEN_RUBBER 077_O 77_O", DynaLaw::ogden, "mooney-rivlin", ""},
    {"RIGID 020 20", DynaLaw::rigid, "[[rigid]]", "", 3},
};

}  // namespace

std::span<const DeckKeywordRule> dynaKeywords() { return dynaRules; }

std::span<const DynaSolid> dynaSolids(std::int64_t form) {
  const auto* begin = std::ranges::lower_bound(dynaSolidRows, form, {}, &DynaSolid::form);
  return {begin, std::ranges::upper_bound(dynaSolidRows, form, {}, &DynaSolid::form)};
}

const DynaLawEntry* findDynaLaw(std::string_view name) {
  for (const DynaLawEntry& law : dynaLaws)
    for (std::size_t begin = 0; begin < law.names.size();) {
      const std::size_t end = std::min(law.names.find(' ', begin), law.names.size());
      if (law.names.substr(begin, end - begin) == name) return &law;
      begin = end + 1;
    }
  return nullptr;
}

std::string dynaHelp() {
  std::string text =
      "LS-DYNA decks likewise; \"*DATABASE_*\" are all keywords that begin so and that stand in no other row; _TITLE "
      "and "
      "_ID go\nwith all of them. Whatever is not listed is refused.\n\n" +
      keywordListing(dynaRules);
  text += "\nlaws (*MAT_), with what becomes of them; of others a part of solid elements is refused:\n";
  for (const DynaLawEntry& law : dynaLaws) {
    const std::size_t first = law.names.find(' ');
    std::string other(law.names.substr(first + 1, law.names.find(' ', first + 1) - first - 1));
    text += fmt::format("  *MAT_{:<23} {}{}{}\n", fmt::format("{}, {}", law.names.substr(0, first), other), law.model,
                        law.why.empty() ? "" : ": ", law.why);
  }
  text += "\nformulations (*SECTION_SOLID, ELFORM), with their quadrature; whatever is not listed is refused:\n";
  for (const DynaSolid& solid : dynaSolidRows)
    text += solid.element.empty() ? fmt::format("  {:>3}  refused: {}\n", solid.form, solid.why)
                                  : fmt::format("  {:>3}  {} with {}{}{}\n", solid.form, solid.element, solid.rule,
                                                solid.why.empty() ? "" : ": ", solid.why);
  return text;
}

}  // namespace ringwatch
