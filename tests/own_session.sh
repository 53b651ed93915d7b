#!/bin/sh
# Runs a command, such as mpirun, with a folder of its own for the sessions of Open MPI: two that
# are started at once would make one folder at the same time, and one of them would fail.
# Without hwloc's look at displays: it ends the program if a display is closed meanwhile, as those
# of the window's tests are.
session=$(mktemp -d) || exit 1
trap 'rm -rf "$session"' EXIT
OMPI_MCA_orte_tmpdir_base=$session PRTE_MCA_prte_tmpdir_base=$session HWLOC_COMPONENTS=-gl "$@"
