# shellcheck shell=bash
# The EXAMPLES of the man pages; tests/manual/pages_test.py runs this file.
(ulimit -f 999; ! rupture load --until 1ms -o killed.h5 --record killed-record.h5 --record-every 1us)
rupture load -o load.h5 --until 1ms --record load-record.h5
rupture prepare --tau-bar 0.2 --sigma-bar 0.1 -o prepared.h5
rupture restart prepared.h5 -o event.h5 --until-quiet --record event-record.h5 --fields 0.1ms
rupture modify-phi prepared.h5 -o bell.h5 --shape bell --x-from 50mm
cp event.h5 edited.h5; /usr/bin/python3 -c 'import h5py; h5py.File("edited.h5", "r+").attrs["by"] = "h5py"'
rupture seal edited.h5 -o sealed.h5
rupture finish killed-record.h5.part -o killed-record.h5
rupture analyze events event-record.h5
rupture analyze front event-record.h5 --stencil 7 --json
rupture analyze classify event-record.h5
rupture analyze slip event-record.h5 --x 70mm --csv
rupture analyze slow-slip event-record.h5
rupture analyze loading load-record.h5 --csv
rupture analyze stress load.h5 --csv
rupture analyze phi bell.h5 --bins 40 --json
rupture analyze strength --shape bell --sigma-bar 0.2
rupture analyze estimate load.h5
rupture analyze steady-state --points 5 --v-from 1e-4
rupture analyze quantities
rupture analyze checksum event.h5
rupture analyze verify event.h5 event-record.h5
rupture analyze diff event.h5 sealed.h5
rupture analyze show event.h5
rupture analyze lineage event-record.h5 --commands
rupture parameters junctions
rupture reproduce list
rupture map event-record.h5 -o map.png
rupture movie event-record.h5 -o film.gif --event first-spanning --frames 20
rupture xdmf prepared.h5 event.h5 -o event.xdmf
