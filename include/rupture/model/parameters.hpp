// The physical and numerical parameters of one simulation (Table S1 of the paper).
//
// Every parameter is declared once, in parameters.cpp: its name, symbol, unit, validity, help, the
// laws that use it, since when there is such a parameter, and whether a restart may change it; its
// default stands in the struct. Options, INI files, checkpoints, their checksums, restarts and
// error messages all read that one table.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "rupture/model/along_x.hpp"
#include "rupture/model/exact_arithmetic.hpp"

namespace rupture {

/// Distribution T(t_R) of the time a junction spends slipping (Methods).
enum class SlippingTimes { gaussian, exponential };

/// Force f_new that a junction carries when it is pinned again: zero (reference) or f_slip, which
/// switches slow slip off (Fig. 3B).
enum class NewForce { zero, f_slip };

/// What a junction does once it has broken (forces/interface_law.hpp): the reference law, the
/// simplified one with a single spring per block (Fig. S2), the decaying one (Fig. S6), or the
/// distance law, in which junctions slip for a distance.
enum class Law { reference, simplified, decaying, distance };

/// What supports the slider in z: an elastic foundation below the bottom row, with F_N on the top
/// row; or, for prepared interfaces, a ceiling above the top row, with F_N on the bottom row.
enum class Support { foundation, ceiling };

/// The normal force in the stiffness k_ij of a block's junctions: its p_i, or always the load on
/// its column, F_N / N_x times slider.load. A foundation spreads the load, so that p_i differs even
/// at the start.
enum class StiffnessFrom { current, initial };

/// What becomes of the pinned junctions of a block without contact: they follow it, or they break.
enum class WithoutContact { follow, break_all };

/// How the decaying law pins a junction: where it is, or so that it carries exactly f_new.
enum class Repin { as_is, exact };

/// Bulk springs pull along their current direction, or are linearised for small displacements.
enum class BulkSprings { exact, linearised };

/// Springs along the slider's faces are as stiff as inner ones, or half as stiff, because they
/// belong to one cell of the lattice and inner ones to two.
enum class EdgeSprings { full, half };

/// Bulk dampers resist the relative velocity of two blocks, or its part along their spring.
enum class DampingAlong { velocity, spring };

struct Parameters {
  // slider
  double L = 0.140;      ///< length along x [m]
  double H = 0.075;      ///< height along z [m]
  double B = 0.006;      ///< width along y [m]
  std::int64_t Nx = 57;  ///< blocks along x
  std::int64_t Nz = 31;  ///< blocks along z
  double M = 0.0756;     ///< mass [kg]
  double E = 3e9;        ///< Young's modulus [Pa]
  BulkSprings springs = BulkSprings::exact;
  EdgeSprings edge_springs = EdgeSprings::full;
  double damping = 0.1;  ///< eta^2 / (k m), dimensionless
  DampingAlong damping_along = DampingAlong::velocity;
  double F_N = 1920;                ///< normal load [N]
  AlongX<double> load = 1.0;        ///< weight of F_N on a block of the row that carries it
  double foundation = 0.5;          ///< k_f / k, dimensionless
  double foundation_damping = 0.0;  ///< eta_f^2 / (k_f m), dimensionless
  Support support = Support::foundation;
  // driving
  double K = 4e6;     ///< driving spring modulus [N/m]
  double h = 0.005;   ///< driving height above the interface [m]
  double V = 0.4e-3;  ///< driving speed [m/s]
  // junctions
  Law law = Law::reference;
  std::int64_t N_s = 100;         ///< junctions per interface block
  AlongX<double> mu_s = 0.4;      ///< f_thres / f_N
  AlongX<double> mu_d = 0.17;     ///< f_slip / f_N
  AlongX<double> kappa = 39.2e9;  ///< k_ij^2 / f_N [N/m^2]
  StiffnessFrom k_ij_from = StiffnessFrom::current;
  AlongX<double> t_R = 2e-3;          ///< mean slipping time [s]
  AlongX<double> delta_t_R = 0.6e-3;  ///< standard deviation of the slipping time [s]
  SlippingTimes slipping_times = SlippingTimes::gaussian;
  AlongX<NewForce> f_new = NewForce::zero;
  WithoutContact without_contact = WithoutContact::follow;
  AlongX<double> d_R = 1e-6;          ///< mean slipping distance of the distance law [m]
  AlongX<double> delta_d_R = 0.3e-6;  ///< standard deviation of that distance [m]
  AlongX<double> mu_new = 0.119;      ///< f_new / f_N of the decaying law, 0.7 mu_d
  Repin repin = Repin::as_is;         ///< of the decaying law
  AlongX<double> v_slow = 1.5e-3;     ///< speed of slow slip that the simplified law imposes [m/s]
  // numerics
  double dt = 2e-7;       ///< time step [s]
  std::int64_t seed = 1;  ///< key of the random numbers

  bool operator==(const Parameters&) const = default;
};

/// The member of Parameters that a table row describes.
using ParameterMember =
    std::variant<double Parameters::*, AlongX<double> Parameters::*, AlongX<NewForce> Parameters::*,
                 std::int64_t Parameters::*, SlippingTimes Parameters::*, Law Parameters::*,
                 Support Parameters::*, StiffnessFrom Parameters::*, WithoutContact Parameters::*,
                 Repin Parameters::*, BulkSprings Parameters::*, EdgeSprings Parameters::*,
                 DampingAlong Parameters::*>;

/// Whether a restart may give a parameter another value; not if it gives the state its meaning.
enum class Restart { may_change, must_keep };

/// Since when files have a parameter, which decides how it counts in their checksum
/// (docs/schema.md).
enum class Since {
  original,  ///< all files have it
  later      ///< older files lack it; it counts only where it differs from its default
};

/// The values that a parameter may have.
struct Valid {
  double minimum = 0, maximum = 0;           ///< of a number
  bool minimum_excluded = false;             ///< whether it must be above `minimum`
  std::vector<std::string_view> words = {};  ///< of an enumeration, in its order; none: a number
};

/// One row of the parameter table. Where not all laws use it, or not all files have it, its default
/// can never change: checksums depend on it.
struct ParameterInfo {
  std::string_view name;    ///< as in options, INI files and /parameters, e.g. "slider.L"
  std::string_view symbol;  ///< as in the paper, e.g. "L"
  std::string_view unit;    ///< SI unit, "1" for none
  ParameterMember member;
  Valid valid;
  std::string_view help;
  std::vector<Law> laws = {};  ///< that use it; none: all of them
  Since since = Since::original;
  Restart restart = Restart::may_change;
};

/// All parameters in the order in which they are shown and stored.
const std::vector<ParameterInfo>& parameter_table();

/// The row called `name`. Throws UsageError naming the nearest existing name.
const ParameterInfo& find_parameter(std::string_view name);

bool is_used(const ParameterInfo& info, Law law);

/// Its value as parameter_text() if the law of `parameters` uses it, and its default if not: what
/// the results depend on.
std::string used_text(const Parameters& parameters, const ParameterInfo& info);

/// The values that a number may have, as in "above 0 and at most 1000".
std::string range_text(const ParameterInfo& info);

/// Sets one parameter from text. One that may vary along x takes "VALUE from X to X" for the blocks
/// there (the others keep theirs), or the values of all blocks, equal neighbours as COUNTxVALUE and
/// all separated by commas. Throws UsageError if the name is unknown, the text is not a value of
/// the right kind, or the value is outside the row's validity range.
void set_parameter(Parameters& parameters, std::string_view name, std::string_view text);

/// The value as text that set_parameter reads back to the same bits.
std::string parameter_text(const Parameters& parameters, const ParameterInfo& info);

/// The values that such a text gives to a slider of these parameters; those it leaves out are zero.
AlongX<double> values_along_x(const Parameters& parameters, const ParameterInfo& info,
                              std::string_view text);
std::string along_x_text(const AlongX<double>& values);  ///< that it reads back to the same bits

/// Whether the text is one that gives blocks different values.
bool is_along_x(std::string_view text);
bool may_vary_along_x(const ParameterInfo& info);

/// Parameters that are everywhere those of block i.
Parameters at_block(const Parameters& parameters, std::int64_t i);

/// The rows of the parameters that vary along x.
std::vector<const ParameterInfo*> varying(const Parameters& parameters);

/// The rows of the parameters in which two sets differ.
std::vector<const ParameterInfo*> differing(const Parameters& a, const Parameters& b);

/// Throws UsageError if a property has values for another number of blocks than Nx.
void validate_lengths(const Parameters& parameters);

/// Throws UsageError unless the parameters make physical sense together: equal lattice spacing in x
/// and z, driving height on a row of blocks, mu_d <= mu_s, f_new and mu_new as the interface law
/// allows them, time step below the stability limit.
void validate(const Parameters& parameters);

}  // namespace rupture
