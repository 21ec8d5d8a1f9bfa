#include <ringwatch/app/scene/deck_keywords.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <ringwatch/app/scene/dyna_keywords.h>

namespace ringwatch {
namespace {

constexpr std::string_view noContact =
    "of contact *CONTACT PAIR and *CONTACT INCLUSIONS, ALL EXTERIOR are taken, hard and with one coefficient of "
    "friction";
constexpr std::string_view byPenalty =
    "contact here is by penalty, of a stiffness at the nodes that the step has room for";
constexpr std::string_view notDynamic = "is no *DYNAMIC step";
constexpr std::string_view notWritten =
    "makes or moves nodes or elements and is not supported; write them out with *NODE and *ELEMENT";
constexpr std::string_view addsMass =
    "adds mass, which changes the step; handler.method = \"mass-scaling\" of a scene does that";
constexpr std::string_view otherMass =
    "gives mass to elements that do not need it; TYPE=BELOW MIN, or a FACTOR, is what there is";
constexpr std::string_view otherMaterials = "changes the tangent from point to point";
constexpr std::string_view ownEstimate = "the program's own estimate of the step; the proven bracket stands for it";
constexpr std::string_view ofImplicit = "controls an implicit scheme, and the scheme here is explicit";
constexpr std::string_view laterInTime = "moves the times of its amplitude";

/// Every keyword of Abaqus and CalculiX that is known. One that is not here is refused.
constexpr DeckKeywordRule keywordRules[] = {
    {DeckRule::mesh,
     "NODE SYSTEM NGEN NFILL ELEMENT ELGEN NSET ELSET PART ENDPART ASSEMBLY ENDASSEMBLY INSTANCE ENDINSTANCE INCLUDE"},
    {DeckRule::taken,
     "MATERIAL ELASTIC HYPERELASTIC DENSITY DAMPING BULKVISCOSITY FIXEDMASSSCALING VARIABLEMASSSCALING SECTIONCONTROLS "
     "SOLIDSECTION MASS SPRING DASHPOT RIGIDBODY BOUNDARY INITIALCONDITIONS SURFACE CONTACT CONTACTINCLUSIONS "
     "CONTACTPROPERTYASSIGNMENT CONTACTPAIR SURFACEINTERACTION FRICTION SURFACEBEHAVIOR STEP ENDSTEP DYNAMIC"},
    {DeckRule::takenInRun, "AMPLITUDE CLOAD DLOAD DSLOAD"},
    {DeckRule::other, "HOURGLASSSTIFFNESS", hourglassHere},
    // What the program does besides, axes of isotropic laws, and what only temperatures, fluids and currents need.
    {DeckRule::harmless,
     "HEADING PREPRINT TIMEPOINTS CONTROLS SOLVERCONTROLS SOLUTIONTECHNIQUE DIAGNOSTICS DOMAINDECOMPOSITION "
     "DISPLAYBODY "
     "ORIENTATION NORMAL SURFACEPROPERTY PHYSICALCONSTANTS CONDUCTIVITY SPECIFICHEAT LATENTHEAT INELASTICHEATFRACTION "
     "JOULEHEATFRACTION FILMPROPERTY EMISSIVITY ELECTRICALCONDUCTIVITY MAGNETICPERMEABILITY DIELECTRIC DIFFUSIVITY "
     "SOLUBILITY FLUIDCONSTANTS SPECIFICGASCONSTANT"},
    {DeckRule::output,
     "NODEFILE ELFILE NODEPRINT ELPRINT FACEPRINT SECTIONPRINT SECTIONFILE CONTACTFILE CONTACTPRINT CONTACTOUTPUT "
     "NODEOUTPUT ELEMENTOUTPUT ENERGYOUTPUT ENERGYFILE ENERGYPRINT INCREMENTATIONOUTPUT INTEGRATEDOUTPUT "
     "INTEGRATEDOUTPUTSECTION MODALFILE MODALOUTPUT MODALPRINT RADIATIONFILE RADIATIONOUTPUT RADIATIONPRINT "
     "SURFACEOUTPUT TORQUEPRINT TRACERPARTICLE OUTPUT FILEOUTPUT POSTOUTPUT USEROUTPUTVARIABLES ELEMENTMATRIXOUTPUT "
     "ELEMENTOPERATOROUTPUT CONTOURINTEGRAL FAILSTRAIN FAILSTRESS FILTER FILEFORMAT PRINT MONITOR RESTART"},
    {DeckRule::procedure,
     "STATIC FREQUENCY COMPLEXFREQUENCY BUCKLE MODALDYNAMIC STEADYSTATEDYNAMICS STEADYSTATETRANSPORT RANDOMRESPONSE "
     "RESPONSESPECTRUM DIRECTCYCLIC SENSITIVITY ROBUSTDESIGN GREEN SUBSTRUCTUREGENERATE MATRIXGENERATE NOANALYSIS "
     "VISCO "
     "CREEPSTRAINRATECONTROL CRACKPROPAGATION SOILS MASSDIFFUSION ELECTROMAGNETIC ELECTROMAGNETICS MAGNETOSTATIC",
     notDynamic},
    {DeckRule::procedure,
     "HEATTRANSFER COUPLEDTEMPERATURE-DISPLACEMENT UNCOUPLEDTEMPERATURE-DISPLACEMENT COUPLEDTHERMAL-ELECTRICAL "
     "DYNAMICTEMPERATURE-DISPLACEMENT",
     noTemperature},
    {DeckRule::procedure, "ANNEAL", "sets all states to rest, which a run does not do"},
    {DeckRule::load, "MODALDAMPING COMPOSITEMODALDAMPING", "damping by modes goes with no *DYNAMIC step"},
    {DeckRule::load,
     "SELECTCYCLICSYMMETRYMODES SELECTEIGENMODES RETAINEDNODALDOFS SUBSTRUCTUREMATRIXOUTPUT BASEMOTION LOADCASE "
     "ENDLOADCASE PSD-DEFINITION SPECTRUM CORRELATION DESIGNVARIABLES DESIGNRESPONSE OBJECTIVE CONSTRAINT "
     "FEASIBLEDIRECTION HCF INERTIARELIEF",
     notDynamic},
    {DeckRule::load,
     "INCIDENTWAVE INCIDENTWAVEPROPERTY INCIDENTWAVEINTERACTION INCIDENTWAVEINTERACTIONPROPERTY "
     "INCIDENTWAVEFLUIDPROPERTY INCIDENTWAVEREFLECTION CONWEPCHARGEPROPERTY UNDEXCHARGEPROPERTY AQUA WAVE WIND",
     "there are no loads of waves; give the pressure by *DSLOAD and an amplitude"},
    {DeckRule::load, "SUBCYCLING",
     "gives some elements smaller steps; handler.method = \"local-time-stepping\" of a scene does that"},
    {DeckRule::load, "EXTREMEVALUE EXTREMENODEVALUE EXTREMEELEMENTVALUE", "may end a run where a value is reached"},
    {DeckRule::temperature,
     "TEMPERATURE CFLUX DFLUX DSFLUX FILM CFILM SFILM RADIATE CRADIATE SRADIATE CECURRENT DECURRENT DSECURRENT"},
    {DeckRule::expansion, "EXPANSION"},
    {DeckRule::refused,
     "PLASTIC CYCLICHARDENING CREEP ANNEALTEMPERATURE RATEDEPENDENT POTENTIAL ORNL DEFORMATIONPLASTICITY HYPERFOAM "
     "HYPOELASTIC LOWDENSITYFOAM ANISOTROPICHYPERELASTIC MULLINSEFFECT VISCOELASTIC HYSTERESIS TRS VISCOUS EOS "
     "EOSCOMPACTION FABRIC UNIAXIAL LOADINGDATA UNLOADINGDATA SUPERELASTIC SUPERELASTICHARDENING POROUSELASTIC "
     "POROUSMETALPLASTICITY POROUSFAILURECRITERIA VOIDNUCLEATION CRUSHABLEFOAM CRUSHABLEFOAMHARDENING CAPPLASTICITY "
     "CAPHARDENING CAPCREEP CASTIRONPLASTICITY CASTIRONCOMPRESSIONHARDENING CASTIRONTENSIONHARDENING CLAYPLASTICITY "
     "CLAYHARDENING DRUCKERPRAGER DRUCKERPRAGERHARDENING DRUCKERPRAGERCREEP MOHRCOULOMB MOHRCOULOMBHARDENING "
     "JOINTEDMATERIAL CONCRETE CONCRETEDAMAGEDPLASTICITY CONCRETECOMPRESSIONHARDENING CONCRETECOMPRESSIONDAMAGE "
     "CONCRETETENSIONSTIFFENING CONCRETETENSIONDAMAGE CONCRETEFAILURE TENSIONSTIFFENING SHEARRETENTION FAILURERATIOS "
     "NOCOMPRESSION NOTENSION SWELLING MOISTURESWELLING GEL SORPTION PERMEABILITY POROUSBULKMODULI PIEZOELECTRIC "
     "ACOUSTICMEDIUM USERMATERIAL DEPVAR",
     noLaw},
    {DeckRule::refused,
     "DAMAGEINITIATION DAMAGEEVOLUTION DAMAGESTABILIZATION SHEARFAILURE TENSILEFAILURE BRITTLECRACKING BRITTLEFAILURE "
     "BRITTLESHEAR FRACTURECRITERION DEBOND ENRICHMENT ENRICHMENTACTIVATION",
     "nothing fails in a deck; [erosion] of a scene takes elements out"},
    {DeckRule::refused,
     "UNIAXIALTESTDATA BIAXIALTESTDATA PLANARTESTDATA VOLUMETRICTESTDATA SHEARTESTDATA SIMPLESHEARTESTDATA "
     "TRIAXIALTESTDATA COMBINEDTESTDATA",
     "constants are not fitted; give those that Abaqus prints"},
    {DeckRule::refused,
     "CONTACTEXCLUSIONS CONTACTFORMULATION CONTACTCONTROLS CONTACTCONTROLSASSIGNMENT CONTACTCLEARANCE "
     "CONTACTCLEARANCEASSIGNMENT CONTACTINITIALIZATIONDATA CONTACTINITIALIZATIONASSIGNMENT CONTACTINTERFERENCE "
     "CONTACTDAMPING CONTACTSTABILIZATION CONTACTPERMEABILITY CLEARANCE SURFACEPROPERTYASSIGNMENT CHANGEFRICTION "
     "CHANGECONTACTTYPE CHANGESURFACEBEHAVIOR COHESIVEBEHAVIOR PRESSUREPENETRATION BOND SLIDELINE RIGIDSURFACE "
     "GAPCONDUCTANCE GAPHEATGENERATION GAPRADIATION GAPFLOW GAPELECTRICALCONDUCTANCE",
     noContact},
    {DeckRule::refused,
     "TIE EQUATION MPC NETWORKMPC COUPLING KINEMATIC DISTRIBUTING KINEMATICCOUPLING DISTRIBUTINGCOUPLING "
     "SHELLTOSOLIDCOUPLING EMBEDDEDELEMENT FASTENER FASTENERPROPERTY RELEASE CYCLICSYMMETRYMODEL PRE-TENSIONSECTION "
     "CONSTRAINTCONTROLS",
     noConstraint},
    {DeckRule::refused, "TRANSFORM", "turns the axes of nodes"},
    {DeckRule::refused, "NCOPY ELCOPY NMAP SYMMETRICMODELGENERATION IMPERFECTION REFINEMESH", notWritten},
    {DeckRule::refused,
     "ADAPTIVEMESH ADAPTIVEMESHCONSTRAINT ADAPTIVEMESHCONTROLS ADAPTIVEMESHREFINEMENT EULERIANBOUNDARY "
     "EULERIANMESHMOTION",
     "moves nodes within the body"},
    {DeckRule::refused,
     "SHELLSECTION SHELLGENERALSECTION MEMBRANESECTION SURFACESECTION BEAMSECTION BEAMGENERALSECTION "
     "BEAMSECTIONGENERATE BEAMSECTIONOFFSET BEAMADDEDINERTIA BEAMFLUIDINERTIA FRAMESECTION SECTIONPOINTS SECTIONORIGIN "
     "TRANSVERSESHEAR SHEARCENTER NODALTHICKNESS PLASTICAXIAL PLASTICM1 PLASTICM2 PLASTICTORQUE AXIAL TORQUE M1 M2 "
     "COHESIVESECTION CONNECTORSECTION CONNECTORBEHAVIOR CONNECTORCONSTITUTIVEREFERENCE CONNECTORDAMAGEEVOLUTION "
     "CONNECTORDAMAGEINITIATION CONNECTORDAMPING CONNECTORDERIVEDCOMPONENT CONNECTORELASTICITY CONNECTORFAILURE "
     "CONNECTORFRICTION CONNECTORHARDENING CONNECTORLOAD CONNECTORLOCK CONNECTORMOTION CONNECTORPLASTICITY "
     "CONNECTORPOTENTIAL CONNECTORSTOP CONNECTORUNIAXIALBEHAVIOR EULERIANSECTION DISCRETESECTION FLUIDSECTION "
     "FLUIDBEHAVIOR FLUIDCAVITY FLUIDEXCHANGE FLUIDINFLATOR FLUIDLINK FLUIDPROPERTY GASKETSECTION GASKETBEHAVIOR GAP "
     "JOINT JOINTELASTICITY ITS EPJOINT DRAGCHAIN PIPE-SOILINTERACTION REBAR REBARLAYER ROTARYINERTIA HEATCAP "
     "INTERFACE "
     "USERELEMENT USERSECTION UELPROPERTY ELEMENTPROPERTIES MATRIXINPUT MATRIXASSEMBLE SUBSTRUCTUREPROPERTY "
     "FLEXIBLEBODY ACOUSTICFLOWVELOCITY SIMPEDANCE IMPEDANCE",
     noStructure},
    {DeckRule::refused, "FOUNDATION", "adds springs to faces; *SPRING of nodes is taken"},
    {DeckRule::refused, "NONSTRUCTURALMASS MASSADJUST", addsMass},
    {DeckRule::refused, "GLOBALDAMPING DAMPINGCONTROLS",
     "is of the procedures of vibrations; *DAMPING of a material is taken"},
    {DeckRule::refused, "DISTRIBUTION DISTRIBUTIONTABLE FIELD USERDEFINEDFIELD TABLECOLLECTION PROPERTYTABLE",
     otherMaterials},
    {DeckRule::refused, "CHANGEMATERIAL CHANGEPLASTIC CHANGESOLIDSECTION", "changes the material along the run"},
    {DeckRule::refused, "PRESSURESTRESS GEOSTATIC PRESTRESSHOLD", notAtRest},
    {DeckRule::refused, "MODELCHANGE ACTIVATEELEMENTS", "takes elements out of the body, or puts them in"},
    {DeckRule::refused,
     "IMPORT IMPORTCONTROLS IMPORTELSET IMPORTNSET IMPORTSURFACE MAPSOLUTION SYMMETRICRESULTSTRANSFER",
     "goes on with the state of another run"},
    {DeckRule::refused, "SUBMODEL EXTERNALFIELD CO-SIMULATION CO-SIMULATIONCONTROLS CO-SIMULATIONREGION", elsewhere},
    {DeckRule::refused, "PARAMETER PARAMETERDEPENDENCE PARAMETERSHAPEVARIATION",
     "its names stand for numbers in other lines; write the numbers out"},
};

/// Every parameter that is known of the keywords that are taken, and those of others that are not harmless. Of a
/// keyword that is taken, one that is not here is refused.
constexpr DeckParameterRule parameterRules[] = {
    {"RESTART", "READ", "", DeckRule::refused, "goes on with the state of another run"},
    {"MATERIAL", "NAME", "", DeckRule::taken},
    {"ELASTIC", "TYPE", "ISO", DeckRule::taken},
    {"ELASTIC", "TYPE", "ISOTROPIC", DeckRule::taken},
    {"ELASTIC", "TYPE", "", DeckRule::refused, noLaw},
    {"ELASTIC", "MODULI", "", DeckRule::taken},
    {"ELASTIC", "DEPENDENCIES", "", DeckRule::refused, otherMaterials},
    {"HYPERELASTIC", "NEOHOOKE", "", DeckRule::taken},
    {"HYPERELASTIC", "MOONEY-RIVLIN", "", DeckRule::taken},
    {"HYPERELASTIC", "YEOH", "", DeckRule::taken},
    {"HYPERELASTIC", "MODULI", "", DeckRule::taken},
    {"DENSITY", "DEPENDENCIES", "", DeckRule::refused, otherMaterials},
    {"DAMPING", "ALPHA", "", DeckRule::taken},
    {"DAMPING", "BETA", "", DeckRule::taken},
    {"DAMPING", "STRUCTURAL", "", DeckRule::refused, "is of a vibration of one frequency"},
    {"DAMPING", "COMPOSITE", "", DeckRule::refused, "is of modes"},
    {"FIXEDMASSSCALING", "FACTOR", "", DeckRule::taken},
    {"FIXEDMASSSCALING", "ELSET", "", DeckRule::taken},
    {"FIXEDMASSSCALING", "DT", "", DeckRule::taken},
    {"FIXEDMASSSCALING", "TYPE", "BELOWMIN", DeckRule::taken},
    {"FIXEDMASSSCALING", "TYPE", "", DeckRule::refused, otherMass},
    {"VARIABLEMASSSCALING", "DT", "", DeckRule::taken},
    {"VARIABLEMASSSCALING", "TYPE", "BELOWMIN", DeckRule::taken},
    {"VARIABLEMASSSCALING", "TYPE", "", DeckRule::refused, otherMass},
    {"VARIABLEMASSSCALING", "FREQUENCY", "", DeckRule::taken},  // masses stay, and steps are divided
    {"VARIABLEMASSSCALING", "NUMBERINTERVAL", "", DeckRule::taken},
    {"VARIABLEMASSSCALING", "ELSET", "", DeckRule::refused,
     "mass is added for the step of the whole body; leave the set out"},
    {"SECTIONCONTROLS", "NAME", "", DeckRule::taken},
    {"SECTIONCONTROLS", "HOURGLASS", "", DeckRule::other, hourglassHere},
    {"SECTIONCONTROLS", "KINEMATICSPLIT", "AVERAGESTRAIN", DeckRule::taken},
    {"SECTIONCONTROLS", "SECONDORDERACCURACY", "", DeckRule::taken},  // of laws of rates
    {"SECTIONCONTROLS", "DISTORTIONCONTROL", "NO", DeckRule::taken},
    {"SECTIONCONTROLS", "DISTORTIONCONTROL", "", DeckRule::refused, "adds forces against inversion"},
    {"SECTIONCONTROLS", "ELEMENTDELETION", "", DeckRule::taken},  // elastic laws do not fail
    {"SECTIONCONTROLS", "MAXDEGRADATION", "", DeckRule::taken},
    {"SOLIDSECTION", "ELSET", "", DeckRule::taken},
    {"SOLIDSECTION", "MATERIAL", "", DeckRule::taken},
    {"SOLIDSECTION", "ORIENTATION", "", DeckRule::taken},  // the laws have no axes
    {"SOLIDSECTION", "NODALTHICKNESS", "", DeckRule::taken},
    {"SOLIDSECTION", "CONTROLS", "", DeckRule::taken},  // *SECTION CONTROLS says what of them is not
    {"SOLIDSECTION", "COMPOSITE", "", DeckRule::refused, "there are no layers"},
    {"MASS", "ELSET", "", DeckRule::taken},
    {"SPRING", "ELSET", "", DeckRule::taken},
    {"SPRING", "NONLINEAR", "", DeckRule::refused, "springs here are linear"},
    {"DASHPOT", "ELSET", "", DeckRule::taken},
    {"DASHPOT", "NONLINEAR", "", DeckRule::refused, "dashpots here are linear"},
    {"RIGIDBODY", "REFNODE", "", DeckRule::taken},
    {"RIGIDBODY", "ROTNODE", "", DeckRule::taken},
    {"RIGIDBODY", "ELSET", "", DeckRule::taken},
    {"RIGIDBODY", "NSET", "", DeckRule::taken},
    {"RIGIDBODY", "TIENSET", "", DeckRule::taken},
    {"RIGIDBODY", "PINNSET", "", DeckRule::taken},  // a solid's nodes do not turn
    {"RIGIDBODY", "ISOTHERMAL", "", DeckRule::taken},
    {"RIGIDBODY", "POSITION", "INPUT", DeckRule::taken},
    {"RIGIDBODY", "POSITION", "CENTEROFMASS", DeckRule::taken},
    {"RIGIDBODY", "ANALYTICALSURFACE", "", DeckRule::refused, "has no elements; [[obstacle]] of a scene is one"},
    {"BOUNDARY", "AMPLITUDE", "", DeckRule::taken},
    {"BOUNDARY", "TYPE", "DISPLACEMENT", DeckRule::taken},
    {"BOUNDARY", "TYPE", "VELOCITY", DeckRule::taken},
    {"BOUNDARY", "OP", "NEW", DeckRule::taken},
    {"BOUNDARY", "OP", "MOD", DeckRule::taken},
    {"BOUNDARY", "REGIONTYPE", "", DeckRule::taken},
    {"BOUNDARY", "USER", "", DeckRule::refused, elsewhere},
    {"BOUNDARY", "SUBMODEL", "", DeckRule::refused, elsewhere},
    {"BOUNDARY", "FIXED", "", DeckRule::refused, "holds what a step before has moved"},
    {"BOUNDARY", "LOADCASE", "", DeckRule::refused, "is of complex values"},
    {"BOUNDARY", "TIMEDELAY", "", DeckRule::refused, laterInTime},
    {"AMPLITUDE", "NAME", "", DeckRule::taken},
    {"AMPLITUDE", "TIME", "TOTALTIME", DeckRule::taken},  // the only step begins at 0
    {"AMPLITUDE", "TIME", "STEPTIME", DeckRule::taken},
    {"AMPLITUDE", "DEFINITION", "TABULAR", DeckRule::taken},
    {"AMPLITUDE", "DEFINITION", "SMOOTHSTEP", DeckRule::taken},
    {"AMPLITUDE", "SMOOTH", "0", DeckRule::taken},
    {"AMPLITUDE", "SMOOTH", "0.", DeckRule::taken},
    {"AMPLITUDE", "VALUE", "RELATIVE", DeckRule::taken},
    {"INITIALCONDITIONS", "TYPE", "VELOCITY", DeckRule::taken},
    {"INITIALCONDITIONS", "TYPE", "TEMPERATURE", DeckRule::temperature},
    {"INITIALCONDITIONS", "TYPE", "STRESS", DeckRule::refused, notAtRest},
    {"INITIALCONDITIONS", "TYPE", "PLASTICSTRAIN", DeckRule::refused, notAtRest},
    {"INITIALCONDITIONS", "TYPE", "DISPLACEMENT", DeckRule::refused, notAtRest},
    {"INITIALCONDITIONS", "TYPE", "FIELD", DeckRule::refused, otherMaterials},
    {"INITIALCONDITIONS", "TYPE", "", DeckRule::refused, "only velocities are taken"},
    {"STEP", "NAME", "", DeckRule::taken},
    {"STEP", "NLGEOM", "", DeckRule::taken},
    {"STEP", "AMPLITUDE", "RAMP", DeckRule::taken},
    {"STEP", "AMPLITUDE", "STEP", DeckRule::taken},
    {"STEP", "INC", "", DeckRule::taken},  // counts of increments, and how a solution is found
    {"STEP", "INCF", "", DeckRule::taken},
    {"STEP", "EXTRAPOLATION", "", DeckRule::taken},
    {"STEP", "CONVERTSDI", "", DeckRule::taken},
    {"STEP", "UNSYMM", "", DeckRule::taken},
    {"STEP", "SOLVER", "", DeckRule::taken},
    {"STEP", "PERTURBATION", "", DeckRule::load, "begins with the stress of the steps before"},
    {"DYNAMIC", "EXPLICIT", "", DeckRule::taken},
    {"DYNAMIC", "DIRECT", "", DeckRule::taken},
    {"DYNAMIC", "DIRECTUSERCONTROL", "", DeckRule::taken},
    {"DYNAMIC", "SCALEFACTOR", "", DeckRule::taken},
    {"DYNAMIC", "SOLVER", "", DeckRule::taken},
    {"DYNAMIC", "ELEMENTBYELEMENT", "", DeckRule::harmless, ownEstimate},
    {"DYNAMIC", "GLOBAL", "", DeckRule::harmless, ownEstimate},
    {"DYNAMIC", "IMPROVEDDTMETHOD", "", DeckRule::harmless, ownEstimate},
    {"DYNAMIC", "FIXEDTIMEINCREMENTATION", "", DeckRule::taken},
    {"DYNAMIC", "ADIABATIC", "", DeckRule::harmless, "heats by inelastic work, and elastic laws do none"},
    {"DYNAMIC", "ALPHA", "", DeckRule::harmless, "damps in an implicit scheme; the explicit one here does not"},
    {"DYNAMIC", "BETA", "", DeckRule::harmless, ofImplicit},
    {"DYNAMIC", "GAMMA", "", DeckRule::harmless, ofImplicit},
    {"DYNAMIC", "APPLICATION", "", DeckRule::harmless, ofImplicit},
    {"DYNAMIC", "HAFTOL", "", DeckRule::harmless, ofImplicit},
    {"DYNAMIC", "HALFINCSCALEFACTOR", "", DeckRule::harmless, ofImplicit},
    {"DYNAMIC", "IMPACT", "", DeckRule::harmless, ofImplicit},
    {"DYNAMIC", "INCREMENTATION", "", DeckRule::harmless, ofImplicit},
    {"DYNAMIC", "INITIAL", "", DeckRule::harmless, ofImplicit},
    {"DYNAMIC", "NOHAF", "", DeckRule::harmless, ofImplicit},
    {"DYNAMIC", "SINGULARMASS", "", DeckRule::harmless, ofImplicit},
    {"DYNAMIC", "TIMEINTEGRATOR", "", DeckRule::harmless, ofImplicit},
    {"DYNAMIC", "SUBSPACE", "", DeckRule::load, "lets modes move alone"},
    {"DYNAMIC", "TIMERESET", "", DeckRule::load, "moves the time that amplitudes go by"},
    {"DYNAMIC", "TOTALTIMEATSTART", "", DeckRule::load, "moves the time that amplitudes go by"},
    {"CLOAD", "AMPLITUDE", "", DeckRule::taken},
    {"CLOAD", "OP", "NEW", DeckRule::taken},
    {"CLOAD", "OP", "MOD", DeckRule::taken},
    {"CLOAD", "REGIONTYPE", "", DeckRule::taken},
    {"CLOAD", "FOLLOWER", "", DeckRule::refused, "turns with its node, and forces here do not"},
    {"CLOAD", "TIMEDELAY", "", DeckRule::refused, laterInTime},
    {"CLOAD", "USER", "", DeckRule::refused, elsewhere},
    {"CLOAD", "SUBMODEL", "", DeckRule::refused, elsewhere},
    {"CLOAD", "LOADCASE", "", DeckRule::refused, "is of complex values"},
    {"CLOAD", "OMEGA0", "", DeckRule::refused, "is of cyclic symmetry"},
    {"CLOAD", "SECTOR", "", DeckRule::refused, "is of cyclic symmetry"},
    {"DLOAD", "AMPLITUDE", "", DeckRule::taken},
    {"DLOAD", "OP", "NEW", DeckRule::taken},
    {"DLOAD", "OP", "MOD", DeckRule::taken},
    {"DLOAD", "REGIONTYPE", "", DeckRule::taken},
    {"DLOAD", "TIMEDELAY", "", DeckRule::refused, laterInTime},
    {"DLOAD", "USER", "", DeckRule::refused, elsewhere},
    {"DLOAD", "LOADCASE", "", DeckRule::refused, "is of complex values"},
    {"DLOAD", "SECTOR", "", DeckRule::refused, "is of cyclic symmetry"},
    {"DSLOAD", "AMPLITUDE", "", DeckRule::taken},
    {"DSLOAD", "OP", "NEW", DeckRule::taken},
    {"DSLOAD", "OP", "MOD", DeckRule::taken},
    {"DSLOAD", "REGIONTYPE", "", DeckRule::taken},
    {"DSLOAD", "TIMEDELAY", "", DeckRule::refused, laterInTime},
    {"DSLOAD", "USER", "", DeckRule::refused, elsewhere},
    {"DSLOAD", "SUBMODEL", "", DeckRule::refused, elsewhere},
    {"DSLOAD", "LOADCASE", "", DeckRule::refused, "is of complex values"},
    {"SURFACE", "NAME", "", DeckRule::taken},
    {"SURFACE", "TYPE", "", DeckRule::taken},
    {"SURFACE", "REGIONTYPE", "", DeckRule::taken},
    {"SURFACE", "INTERNAL", "", DeckRule::taken},
    {"CONTACT", "OP", "NEW", DeckRule::taken},
    {"CONTACT", "OP", "MOD", DeckRule::taken},
    {"CONTACTINCLUSIONS", "ALLEXTERIOR", "", DeckRule::taken},
    {"CONTACTPAIR", "INTERACTION", "", DeckRule::taken},
    {"CONTACTPAIR", "CPSET", "", DeckRule::taken},
    {"CONTACTPAIR", "NOTHICKNESS", "", DeckRule::taken},  // of shells
    {"CONTACTPAIR", "MECHANICALCONSTRAINT", "PENALTY", DeckRule::taken},
    {"CONTACTPAIR", "MECHANICALCONSTRAINT", "", DeckRule::other, byPenalty},
    {"CONTACTPAIR", "TYPE", "NODETOSURFACE", DeckRule::taken},
    {"CONTACTPAIR", "TYPE", "", DeckRule::other, "nodes touch faces here"},
    {"CONTACTPAIR", "SMALLSLIDING", "", DeckRule::other, "nodes slide from face to face here"},
    {"CONTACTPAIR", "ADJUST", "", DeckRule::refused, movesNodes},
    {"SURFACEINTERACTION", "NAME", "", DeckRule::taken},
    {"SURFACEBEHAVIOR", "PRESSURE-OVERCLOSURE", "HARD", DeckRule::taken},
    {"SURFACEBEHAVIOR", "PRESSURE-OVERCLOSURE", "", DeckRule::refused,
     "its pressure goes with the depth, and contact here has a stiffness at nodes; HARD is taken"},
    {"SURFACEBEHAVIOR", "PENALTY", "", DeckRule::taken},
    {"FRICTION", "SLIPTOLERANCE", "", DeckRule::other, "contact.slip says how surfaces that stick creep"},
};

constexpr std::string_view hybrid =
    "its pressure has no unknowns of its own here; take care where Poisson's ratio is close to 0.5";
constexpr std::string_view meanPressure = "its one pressure is that of the mean change of volume, which is the same";
constexpr std::string_view onePoint =
    "one point, with hourglass control of stiffness 0.05 unless material.hourglass_stiffness says otherwise";
constexpr DeckSolid solids[] = {
    {"C3D4", "tet4", "gauss-1"},
    {"C3D4H", "tet4", "gauss-1", meanPressure},
    {"C3D6", "wedge6", "fierz2013"},
    {"C3D6H", "wedge6", "selective", meanPressure},
    {"C3D8", "hex8", "gauss-2x2x2"},
    {"C3D8H", "hex8", "selective", meanPressure},
    {"C3D8R", "hex8", "uniform-strain", onePoint},
    {"C3D8RH", "hex8", "uniform-strain", onePoint},
    {"C3D10", "tet10", "keast-4"},
    {"C3D10H", "tet10", "keast-4", hybrid},
    {"C3D10M", "tet10", "keast-4",
     "the modified tetrahedron of Abaqus, with a softer volume and masses of its own; the quadratic one stands for it, "
     "whose critical step differs"},
    {"C3D10MH", "tet10", "keast-4", "the modified hybrid tetrahedron of Abaqus; the quadratic one stands for it"},
    {"C3D20", "hex20", "gauss-3x3x3"},
    {"C3D20H", "hex20", "gauss-3x3x3", hybrid},
    {"C3D20R", "hex20", "gauss-2x2x2"},
    {"C3D20RH", "hex20", "gauss-2x2x2", hybrid},
    {"C3D8I", "", "", "its incompatible modes are not ours; C3D8 and C3D8R are taken"},
    {"C3D10T", "", "", noElement},
    {"C3D15", "wedge6", "gauss-3x2", cornersAlone},
};

/// Calls each(name) for the names of a row.
template <class Each>
void forEachName(const DeckKeywordRule& row, const Each& each) {
  for (std::size_t begin = 0; begin < row.names.size();) {
    const std::size_t end = std::min(row.names.find(' ', begin), row.names.size());
    each(row.names.substr(begin, end - begin));
    begin = end + 1;
  }
}

/// "*A *B …" in lines of no more than a page's width.
std::string linesOfNames(const DeckKeywordRule& row) {
  constexpr std::size_t width = 100;
  std::string text, line = " ";
  forEachName(row, [&](std::string_view name) {
    if (line.size() + name.size() > width) text += std::exchange(line, " ") + "\n";
    line += fmt::format(" *{}", name);
  });
  return text + line + "\n";
}

}  // namespace

const DeckKeywordRule* findKeywordRule(std::span<const DeckKeywordRule> rules, std::string_view name) {
  const DeckKeywordRule* found = nullptr;
  std::size_t longest = 0;  // what of the name the row says, and one more where it says all
  for (const DeckKeywordRule& row : rules)
    forEachName(row, [&](std::string_view one) {
      const bool family = one.ends_with('*');
      const std::string_view said = one.substr(0, one.size() - (family ? 1 : 0));
      const std::size_t length = said.size() + (family ? 0 : 1);
      if (length <= longest || !(family ? name.starts_with(said) : name == said)) return;
      found = &row;
      longest = length;
    });
  return found;
}

std::span<const DeckKeywordRule> abaqusKeywords() { return keywordRules; }

std::string keywordListing(std::span<const DeckKeywordRule> rules) {
  std::string text;
  for (const auto& [head, rule] : {std::pair{"read with the mesh", DeckRule::mesh},
                                   {"taken", DeckRule::taken},
                                   {"taken by run; inspect leaves them out, with a note", DeckRule::takenInRun},
                                   {"done otherwise, with a note", DeckRule::other},
                                   {"left out, with a note", DeckRule::harmless},
                                   {"output requests, left out with a note", DeckRule::output},
                                   {"left out with a note, but refused with *EXPANSION", DeckRule::temperature},
                                   {"left out with a note, but refused with temperatures", DeckRule::expansion},
                                   {"of no matter to inspect; run refuses them", DeckRule::procedure},
                                   {"likewise", DeckRule::load},
                                   {"refused", DeckRule::refused}})
    for (const DeckKeywordRule& row : rules)
      if (row.rule == rule)
        text += fmt::format("{}{}{}:\n{}", head, row.why.empty() ? "" : ": ", row.why, linesOfNames(row));
  return text;
}

const DeckParameterRule* findParameterRule(std::string_view keyword, std::string_view parameter,
                                           std::string_view value) {
  const auto* found = std::ranges::find_if(parameterRules, [&](const DeckParameterRule& rule) {
    return rule.keyword == keyword && rule.parameter == parameter && (rule.value.empty() || rule.value == value);
  });
  return found == std::end(parameterRules) ? nullptr : found;
}

/// "A, B" of the parameters of a keyword that are taken.
std::string takenParameters(std::string_view keyword) {
  std::vector<std::string> names;
  for (const DeckParameterRule& rule : parameterRules)
    if (rule.keyword == keyword && rule.rule == DeckRule::taken)
      names.push_back(fmt::format("{}{}{}", rule.parameter, rule.value.empty() ? "" : "=", rule.value));
  return fmt::format("{}", fmt::join(names, ", "));
}

const DeckSolid* findDeckSolid(std::string_view type) {
  const auto* found = std::ranges::find(solids, type, &DeckSolid::type);
  return found == std::end(solids) ? nullptr : found;
}

const DeckSolid* findDeckSolidOf(std::string_view element, std::string_view rule) {
  const DeckSolid* first = nullptr;
  for (const DeckSolid& solid : solids) {
    if (solid.element != element || solid.why == cornersAlone) continue;  // those have more nodes
    if (solid.rule == rule) return &solid;
    if (!first) first = &solid;
  }
  return first;
}

std::string deckHelp() {
  std::string text =
      "Abaqus and CalculiX decks in place of a scene (run) or a mesh (inspect); blanks in keywords do not count, and "
      "whatever\nis not listed is refused.\n\n";
  text += keywordListing(keywordRules);
  text += "\nparameters of keywords that are taken, beside INPUT=; whatever is not listed is refused:\n";
  for (const DeckKeywordRule& row : keywordRules)
    forEachName(row, [&](std::string_view name) {
      if (const std::string taken = takenParameters(name); !taken.empty())
        text += fmt::format("  *{:<19} {}\n", name, taken);
    });
  for (const auto& [head, isTold] :
       {std::pair<const char*, bool (*)(DeckRule)>{"left out by run, with a note",
                                                   [](DeckRule r) { return r == DeckRule::harmless; }},
        {"refused by both, or of loads and of *DYNAMIC by run",
         [](DeckRule r) { return r == DeckRule::refused || r == DeckRule::load; }}}) {
    text += fmt::format("parameters, {}:\n", head);
    for (const DeckParameterRule& rule : parameterRules)
      if (isTold(rule.rule))
        text += fmt::format(
            "  {:<35} {}\n",
            fmt::format("*{}, {}{}{}", rule.keyword, rule.parameter, rule.value.empty() ? "" : "=", rule.value),
            rule.why);
  }
  text += "\nelements (*ELEMENT, TYPE=), with their quadrature:\n";
  for (const DeckSolid& solid : solids)
    text += solid.element.empty() ? fmt::format("  {:<8} refused: {}\n", solid.type, solid.why)
                                  : fmt::format("  {:<8} {} with {}{}{}\n", solid.type, solid.element, solid.rule,
                                                solid.why.empty() ? "" : ": ", solid.why);
  return text + "\n" + dynaHelp();
}

}  // namespace ringwatch
