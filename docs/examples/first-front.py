# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

# %% [markdown]
# # The first front, with and without driving
#
# The slider is loaded until a front has crossed its whole interface. Then the run is taken up again
# just before that event, with the driving stopped. Run it cell by cell (VS Code, Spyder, or Jupyter
# with jupytext read these cells) or as a whole: `python3 first-front.py`. It takes half a minute.

# %%
import matplotlib.pyplot as plt
import rupture
from rupture import plotting

# %% [markdown]
# Load for 0.43 s, and keep a checkpoint every 20 ms. A record holds the interface's time series.

# %%
load = rupture.run(
    "load",
    output="load.h5",
    record="load-record.h5",
    until=0.43,
    checkpoint_every=0.02,
    record_every=1e-5,
    force=True,
)
events = rupture.analyze("events", load.record_file)["events"]
first = next(event for event in events if event["spanning"])
print(f"event {first['number']} crosses the interface from {first['t_start']:.4f} s on")

# %% [markdown]
# The other run begins at the last checkpoint before that event. `driving.V` is the speed of the
# driving point.

# %%
before = [c for c in map(rupture.open, load.checkpoints) if c.time < first["t_start"]][-1]
stopped = rupture.run(
    "restart",
    before,
    output="stopped.h5",
    record="stopped-record.h5",
    set={"driving.V": 0},
    for_=0.01,
    record_every=1e-5,
    force=True,
)

# %% [markdown]
# Both fronts: white lines are where blocks rupture. This one began slowly, and needs the driving to
# become fast and to cross.

# %%
figure, axes = plt.subplots(1, 2, figsize=(8, 4), sharey=True, constrained_layout=True)
for panel, run, title in zip(axes, (load, stopped), ("driven", "driving stopped")):
    window = (0, 8)  # [ms] after the checkpoint
    image = plotting.draw_pinned(panel, run.record, before.time, window)
    panel.set_title(title)
plotting.draw_pinned_scale(figure, image, axes)
figure.savefig("first-front.png", dpi=150)
