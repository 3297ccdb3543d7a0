#include "analyze/quantities.hpp"

namespace rupture::tools {
namespace {

using List = std::vector<Quantity>;

List join(const std::vector<List>& lists) {
  List all;
  for (const List& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// The list with `prefix` and a dot before each name.
List within(const std::string& prefix, List list) {
  for (Quantity& quantity : list) quantity.name = prefix + "." + quantity.name;
  return list;
}

// --- what several commands report

const Quantity kType = {"type", "", "none, arrested, slow or fast"};
const Quantity kArrest = {"x_arrest", "m", "furthest ruptured block of an arrested front"};
const Quantity kShearSpeed = {"c_s", "m/s", "speed of shear waves"};
const Quantity kLength = {"L", "m", "length of the interface"};
const Quantity kRuptureTimes = {"t_rupture.*", "s", "first rupture of each block"};
const Quantity kBlocks = {"x.*", "m", "position of each block"};
const Quantity kLoad = {"F_N", "N", "normal load"};

const List kSlow =
    within("slow", {
                       {"x_from", "m", "first block of the slow stretch"},
                       {"x_to", "m", "last block of the slow stretch"},
                       {"t_from", "s", "time at which the slow stretch begins"},
                       {"t_to", "s", "time at which the slow stretch ends"},
                       {"duration", "s", "duration of the slow stretch"},
                       {"speed", "m/s", "median front speed in the slow stretch"},
                       {"fast_before", "m/s", "median front speed before the slow stretch"},
                       {"fast_after", "m/s", "median front speed after the slow stretch"},
                   });

// --- of records

const List kFront = join({
    {kBlocks, kRuptureTimes, {"v_c.*", "m/s", "front speed at each block"}, kType, kArrest},
    kSlow,
    {kShearSpeed, kLength},
});

const List kClassify = {kType, kArrest};

const List kEvents =
    within("events.*", join({
                           {
                               {"number", "1", "as --event counts, from 0"},
                               {"t_start", "s", "first block rupture of the event"},
                               {"t_end", "s", "last block rupture of the event"},
                               {"x_first", "m", "block that ruptured first"},
                               {"x_last", "m", "furthest block that ruptured"},
                               {"spanning", "", "whether the front reached the leading edge"},
                               kType,
                           },
                           kSlow,
                           {
                               {"F_T_before", "N", "driving force at the first rupture"},
                               {"F_T_after", "N", "lowest driving force until the event is over"},
                               kShearSpeed,
                               kLength,
                               kRuptureTimes,
                           },
                       }));

const List kSlip = {
    {"x", "m", "position of the block"},
    {"t_rupture", "s", "first rupture of the block"},
    {"t_arrest", "s", "time at which the block first stops after its rupture"},
    {"fast_slip", "m", "slip until the block first stops"},
    {"slow_slip", "m", "slip from then on"},
    {"slow_from", "s", "start of the fit of the slow slip"},
    {"slow_to", "s", "end of the fit of the slow slip"},
    {"slow_speed", "m/s", "speed of the slow slip"},
    {"slow_speed_error", "m/s", "standard error of that speed"},
    {"slow_r_squared", "1", "R^2 of the fit"},
    {"time.*", "s", "time of each sample"},
    {"slip.*", "m", "slip since the start of the window, at each sample"},
};

const List kSlowSlip = join({
    {kType},
    kSlow,
    {
        {"blocks", "1", "blocks whose slow slip was measured"},
        {"front_speed", "m/s", "median front speed at these blocks"},
        {"speed.mean", "m/s", "mean of their speeds of slow slip"},
        {"speed.min", "m/s", "smallest of their speeds of slow slip"},
        {"speed.max", "m/s", "largest of their speeds of slow slip"},
        {"estimate", "m/s", "mean of Eq. S1 at their normal forces"},
    },
    within("per_block",
           {
               kBlocks,
               {"t_from.*", "s", "start of the fit at each block"},
               {"t_to.*", "s", "end of the fit at each block"},
               {"speed.*", "m/s", "speed of slow slip of each block"},
               {"r_squared.*", "1", "R^2 of the fit at each block"},
               {"v_c.*", "m/s", "front speed at each block"},
               {"estimate.*", "m/s", "Eq. S1 at the normal force on each block"},
           }),
});

const List kLoading = {
    kLoad,
    {"time.*", "s", "time of each sample"},
    {"F_T.*", "N", "driving force at each sample"},
    {"x_drive.*", "m", "position of the driving point at each sample"},
    {"p.*", "N", "normal force on the block of --x at each sample"},
    {"tau.*", "N", "friction force on the block of --x at each sample"},
    {"u_x.*", "m", "displacement of the block of --x at each sample"},
};

// --- of checkpoints

const List kStress = {
    {"time", "s", "time of the checkpoint"},
    kBlocks,
    {"p.*", "N", "normal force on each block"},
    {"tau.*", "N", "friction force on each block, > 0 where it pushes towards -x"},
    {"F_T", "N", "driving force"},
    kLoad,
    {"p_centroid", "m", "centroid of the normal forces, from the middle of the interface"},
};

const List kPhi = {
    kBlocks,
    {"mean.*", "N", "mean junction force of each block"},
    {"sigma.*", "N", "standard deviation of the junction forces of each block"},
    {"sigma_bar.*", "1", "sigma/(f_thres - f_slip) of each block"},
    {"slipping.*", "1", "fraction of slipping junctions of each block"},
    {"f_thres.*", "N", "strength of one junction of each block"},
    {"f_slip.*", "N", "force of one slipping junction of each block"},
    {"histogram.*.*", "1", "junctions of each block in each bin from -f_thres to f_thres"},
};

const List kStrength = {
    {"shape", "", "uniform or bell (of a shape)"},
    {"sigma_bar", "1", "standard deviation over f_thres - f_slip (of a shape)"},
    {"mu_bar_eff", "1", "effective static friction, (tau_max/p - mu_d)/(mu_s - mu_d) (of a shape)"},
    {"mu_eff", "1", "tau_max/p at the default mu_s and mu_d (of a shape)"},
    {"x.*", "m", "position of each block (of a checkpoint)"},
    {"slipping.*", "1", "fraction of slipping junctions of each block (of a checkpoint)"},
    {"sigma_bar.*", "1", "sigma/(f_thres - f_slip) of each block (of a checkpoint)"},
    {"tau_bar_0.*", "1", "(tau/p - mu_d)/(mu_s - mu_d) of each block (of a checkpoint)"},
    {"mu_bar_eff.*", "1", "(tau_max/p - mu_d)/(mu_s - mu_d) of each block (of a checkpoint)"},
    {"mu_eff.*", "1", "tau_max/p of each block (of a checkpoint)"},
};

/// Mean and standard deviation over the ensemble.
List over_ensemble(const std::string& name, const std::string& help) {
  return {{name, "1", help + ", mean over the ensemble"},
          {name + "_deviation", "1", help + ", standard deviation"}};
}

const List kEstimate = join({
    {
        {"v_slow_slip", "m/s", "speed of slow slip by Eq. S1 at the mean normal force"},
        {"p", "N", "mean normal force on a block"},
        {"t_R", "s", "mean slipping time <t_R>"},
    },
    over_ensemble("net_slip_over_f_slip_per_k_ij",
                  "slip until no junction slips any more, in f_slip/k_ij"),
    over_ensemble("slip_after_two_t_R_over_f_slip_per_k_ij", "slip after 2 <t_R>, in f_slip/k_ij"),
    over_ensemble("slip_at_return_over_f_slip_per_k_ij",
                  "slip until each junction has been pinned once, in f_slip/k_ij"),
    over_ensemble("duration_over_t_R", "time until each junction has been pinned once, in <t_R>"),
    over_ensemble("quiet_after_over_t_R", "time until no junction slips any more, in <t_R>"),
    {
        {"relaxation.time_over_t_R.*", "1", "time at which each junction was pinned, in <t_R>"},
        {"relaxation.slip_over_f_slip_per_k_ij.*", "1", "slip at that time, in f_slip/k_ij"},
    },
    within("block",
           {
               kBlocks,
               {"p.*", "N", "normal force on each block"},
               {"v_slow_slip.*", "m/s", "speed of slow slip by Eq. S1 of each block"},
           }),
});

// --- of parameters

const List kSteadyState = {
    {"v.*", "m/s", "each speed"},
    {"mu.*", "1", "measured mean tau/p at each speed"},
    {"mu_error.*", "1", "standard error of mu at each speed"},
    {"mu_theory.*", "1", "tau/p by renewal theory at each speed"},
    {"p", "N", "normal force on the block"},
};

}  // namespace

std::vector<Quantity> quantities() {
  return join({
      within("front", kFront),
      within("classify", kClassify),
      within("events", kEvents),
      within("slip", kSlip),
      within("slow-slip", kSlowSlip),
      within("loading", kLoading),
      within("stress", kStress),
      within("phi", kPhi),
      within("strength", kStrength),
      within("estimate", kEstimate),
      within("steady-state", kSteadyState),
  });
}

}  // namespace rupture::tools
