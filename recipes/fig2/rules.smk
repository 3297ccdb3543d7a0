import shutil

FIG2_LOADS = of_ensemble("load", "events")
FIG2_OF_ALL = len(FIG2_LOADS) == len(REFERENCE_LOADS)
# The film leads the report. With ffmpeg it can be stopped, and a browser shows a still until it is started.
FIG2_FILM, FIG2_STILL = [f"{RESULTS}/movie.gif"], ""
if shutil.which("ffmpeg"):
    FIG2_FILM = [f"{RESULTS}/movie.webm", f"{RESULTS}/movie.png"]
    FIG2_STILL = "&& ffmpeg -v error -y -ss 6 -i {output[0]} -frames:v 1 {output[1]}"
FIG2_EVENTS = [*EVENTS, *(["most-like"] if FIG2_OF_ALL else [])]
RUNS["most-like"] = run("most-like", f"--for {DURATION}")
# Event I as a film of the slider. What happens later than in 4 ms is not slow any more.
RUNS["fast-slow-fast/filmed"] = run(
    "fast-slow-fast", "--for 0.004 --fields 2e-5", record_every="2e-5"
)


rule fig2_choice:
    input:
        events=[f"{DATA}/ensemble/{load}-events.json" for load in REFERENCE_LOADS],
        **script("recipes/fig2/most_like.py"),
    output: f"{DATA}/most-like.json"
    log: f"{LOGS}/most-like.log"
    message: "fig2: choose the event most like the paper's"
    shell: "{CALL} {input.script} {CHECKPOINT_EVERY} {input.events} > {output} 2> {log}"


# Which load it is of is known when the command runs, so that all of them have to be there.
use rule restart_before_event as fig2_before with:
    input:
        choice=f"{DATA}/most-like.json",
        **content_of(
            checkpoints=[
                checkpoint
                for load in REFERENCE_LOADS
                for checkpoint in checkpoints_of_load(f"{DATA}/ensemble/{load}")
            ]
        ),
    output: **with_sums(h5=f"{DATA}/most-like.h5")
    log: f"{LOGS}/most-like-before.log"
    params: **event_of(lambda wildcards, input: f"{DATA}/ensemble/$({VALUE} {input.choice} load)")
    message: "fig2: run to 0.5 ms before the event most like the paper's"


rule fig2_film:
    input:
        **content_of(record=f"{DATA}/fast-slow-fast/filmed-record.h5"),
        drawn_by=sorted(map(str, Path("python/rupture").rglob("*.py"))),
    output: FIG2_FILM
    log: f"{LOGS}/fig2-film.log"
    params: code=CODE
    message: "fig2: film event I"
    shell: "({BIN}/movie {input.record} -o {output[0]} --event 0 --force " + FIG2_STILL + ") > {log} 2>&1"


figure(
    "fig2",
    tables=["front-speed", "front-speed-II", *(["most-like"] if FIG2_OF_ALL else [])],
    events=EVENTS,
    film=FIG2_FILM,
    reads=[
        *(f"{event}-{of}" for event in FIG2_EVENTS for of in ("front.json", "record.h5")),
        *(["most-like.json"] if FIG2_OF_ALL else []),
        *FIG2_LOADS,
    ],
)
