// Quantities that follow from the parameters (Table S1, lower half).
#pragma once

#include "rupture/model/parameters.hpp"

namespace rupture {

inline constexpr double kPoissonRatio = 1.0 / 3.0;  ///< of the square lattice with k and k/2

double block_spacing(const Parameters& p);         ///< l = L / (Nx - 1) [m]
double block_mass(const Parameters& p);            ///< m = M / (Nx Nz) [kg]
double bulk_stiffness(const Parameters& p);        ///< k = 3 B E / 4 [N/m]
double damping_coefficient(const Parameters& p);   ///< eta = sqrt(damping k m) [N s/m]
double foundation_stiffness(const Parameters& p);  ///< k_f = foundation * k [N/m]
double density(const Parameters& p);               ///< rho = M / (L H B) [kg/m^3]
double shear_wave_speed(const Parameters& p);   ///< c_s = sqrt(G / rho), G = E / (2 (1 + nu)) [m/s]
double mean_normal_force(const Parameters& p);  ///< F_N / Nx, mean p of an interface block [N]
/// Part of F_N on column i, F_N / Nx unless slider.load varies [N].
double column_load(const Parameters& p, std::int64_t i);

/// Coefficient of the foundation's dashpots, eta_f = sqrt(foundation_damping k_f m) [N s/m].
double foundation_damping_coefficient(const Parameters& p);

/// Rest length of the bulk springs along x and z, which their forces are computed with [m].
/// Linearised springs are those of endless length: they never turn, and the tension is linear in
/// the displacement. 2^60 l is as good as endless and costs no digits.
double spring_length(const Parameters& p);

/// Modulus of the bulk spring between block (i, j) and block (i + ix, j + iz): k, or k/2 along a
/// diagonal; with slider.edge_springs = half, k/2 along a face of the slider, too [N/m].
double spring_stiffness(const Parameters& p, std::int64_t i, std::int64_t j, int ix, int iz);

/// Position of column i along x, i l [m].
double block_position(const Parameters& p, std::int64_t i);
std::vector<double> block_positions(const Parameters& p);  ///< of all columns [m]
std::vector<double> block_heights(const Parameters& p);    ///< of all rows, from the lowest [m]

/// Row of blocks on which the driving spring acts, h / l.
std::int64_t driving_row(const Parameters& p);

/// Springs between an interface block and the track: N_s junctions, or one under the simplified
/// law.
std::int64_t springs_per_block(const Parameters& p);

/// Junction stiffness k_ij = sqrt(kappa f_N) of block i at normal force p_i = N_s f_N on the block
/// [N/m]. With junctions.k_ij_from = initial, f_N in it is column_load() / N_s wherever there is
/// contact.
double junction_stiffness(const Parameters& p, std::int64_t i, double p_i);

/// Mean <t_R> of the slipping times of block i [s]: of |N(t_R, delta_t_R)|, delta_t_R sqrt(2/pi)
/// exp(-t_R^2 / 2 delta_t_R^2) + t_R erf(t_R / sqrt(2) delta_t_R); of the exponential T, t_R.
double mean_slipping_time(const Parameters& p, std::int64_t i);

/// Stretch w = f_N / k_ij, so that f_thres = k_ij (mu_s w); 0 without contact [m].
double friction_stretch(const Parameters& p, std::int64_t i, double p_i);

/// Largest stable time step of velocity Verlet on this lattice [s].
///
/// With damping taken at the half-kicked velocity a mode of frequency omega and damping rate c is
/// stable for dt < (sqrt(c^2 + 4 omega^2) - c) / omega^2. The stiffest bulk mode has omega^2 = 6
/// k/m and c = 12 eta/m (wave vector (pi, 0)), or 8 eta/m if dampers act along their spring; softer
/// springs along the faces do not change it. A bottom block adds its junctions or the foundation.
/// The foundation's dashpots add eta_f/m to c. No block is taken to bear more than 4 times
/// the largest column_load().
double stable_time_step(const Parameters& p);

/// The stable time step where no block bears more than `largest_p` [N]. Every junction counts as
/// stiff as the stiffest.
double stable_time_step(const Parameters& p, double largest_p);

}  // namespace rupture
