#!/bin/sh
# SPDX-License-Identifier: MIT
# A picture rendered in parts by an engine that is there already, and put together again.
#     shards.sh PROGRAMS FOLDER PARTS          under mpirun where it is found, else under xargs
# Called again, it renders only the parts that are missing: a part's file appears whole or not at all, so whatever was
# killed left none. On a cluster the same line goes into a job array, one part a job:
#     [ -f part-$SLURM_ARRAY_TASK_ID.shard ] || shard part-$SLURM_ARRAY_TASK_ID.shard --part $SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT
set -eu

if [ "${1-}" = --one ]; then  # what the engine runs: it tells its number by a variable, xargs by an argument
    programs=$2 folder=$3 parts=$4
    k=${5-${OMPI_COMM_WORLD_RANK-${PMI_RANK-}}}
    file=$folder/part-$k.shard
    [ -f "$file" ] || exec "$programs/shard" "$file" --part "$k/$parts"
    exit 0
fi

[ $# -eq 3 ] || { echo "usage: shards.sh PROGRAMS FOLDER PARTS" >&2; exit 2; }
programs=$1 folder=$2 parts=$3
mkdir -p "$folder"
if command -v mpirun >/dev/null 2>&1; then
    as_root=''
    if [ "$(id -u)" -eq 0 ]; then as_root=--allow-run-as-root; fi
    mpirun $as_root --oversubscribe -n "$parts" sh "$0" --one "$programs" "$folder" "$parts"
else
    seq 0 $((parts - 1)) | xargs -P "$(getconf _NPROCESSORS_ONLN)" -n 1 sh "$0" --one "$programs" "$folder" "$parts"
fi
"$programs/lantern_merge" "$folder/picture.png" "$folder"/part-*.shard
echo "$folder/picture.png"
