#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Yamagi Quake II records a demo on one of our levels; then the engine with the module and build/vigil play it.
#   demo.sh pictures [BUILD]   their raw pictures of the same frames have the same means, for every pt_nee
#   demo.sh times [BUILD]      16 guards and rockets: times of passes, in turns, as a table and as times.json
# SEEDS, ROUNDS, TECHNIQUES and DEMO (a file, in place of what is recorded) change what is done. PARTICLES=1 times the engine with
# the game's particles, which vigil does not have. See engine.sh for more.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
what=${1:-pictures}
build=${2:-build}
techniques=${TECHNIQUES:-sll lh vlc}
every=6

# shellcheck source=/dev/null
source tests/yamagi/engine.sh
[ -x "$build/vigil" ] || die "$build has no vigil: build it"

# ---- playing ----

# play_engine TECHNIQUE LOG COMMAND ...: the demo, every frame once. The clock stands: time is the demo's. The weapon has the
# angle of the view, as in vigil.
play_engine() {
  local technique=$1 log=$2 line
  shift 2
  {
    printf 'set %s\n' "pt_nee $technique" "pt_guide brdf" "flt_enable 0" "crosshair 0" "r_gunfov -1" "fixedtime 1" "timedemo 1" \
      "vigil_dlight_scale 1" "nextdemo quit"
    for line in "$@"; do printf '%s\n' "$line"; done
    echo "demomap shown.dm2"
  } | run_engine "$width" "$height" "$log"
}

# play_own TECHNIQUE LOG ARGUMENTS ...
play_own() {
  local technique=$1 log=$2
  shift 2
  "$build/vigil" +set basedir "$data" +set outdir "$scratch/out" +set vid_driver headless +set vid_width "$width" \
    +set vid_height "$height" +set pt_nee "$technique" +set pt_guide brdf +set flt_enable 0 +set timedemo 1 "$@" \
    >"$log" 2>&1 || { tail -n 20 "$log" >&2; die "vigil ended badly"; }
}

frames_of() { grep -aoE '[0-9]+ frames, [0-9.]+ seconds: ' "$1" | tail -n 1 | cut -d ' ' -f 1; }

# record COMMANDS: what they do on the warehouse becomes the demo `shown`; 20 of the engine's frames are a second.
record() {
  if [ -n "${DEMO:-}" ]; then
    cp "$DEMO" "$home/.yq2/baseq2/demos/shown.dm2"
    cp "$DEMO" "$scratch/out/demos/shown.dm2"
    chmod a+r "$home/.yq2/baseq2/demos/shown.dm2"
    return
  fi
  step "Recording"
  {
    printf '%s\n' "set fixedtime 50000" "set cheats 1" "set pt_nee sll" "set pt_guide brdf" "set flt_enable 0" \
      "map warehouse" "notarget"
    waits 30
    echo "$1"
    echo "record shown"
    echo "$2"
    printf '%s\n' stop wait wait quit
  } | run_engine 80 60 "$scratch/record.log"
  [ -s "$home/.yq2/baseq2/demos/shown.dm2" ] || die "no demo was recorded: $scratch/record.log"
  cp "$home/.yq2/baseq2/demos/shown.dm2" "$scratch/out/demos/"
}

pictures() {
  width=160 height=120
  # Standing and walking among guards; at the end, shots.
  record wait "$(waits 10; echo +forward; waits 24; echo -forward; echo +left; waits 8; echo -left; waits 8; echo +right
    waits 8; printf '%s\n' -right +moveleft; waits 8; echo -moveleft; waits 6; echo +attack; waits 10; echo -attack
    waits 10)"
  local seed technique frames own
  cp "$scratch/out/demos/shown.dm2" "$scratch/pictures/demo.dm2"
  for technique in $techniques; do
    for seed in $(seq "${SEEDS:-12}"); do
      play_engine "$technique" "$scratch/engine.log" "set pt_seed $seed" "set vigil_timedemo_every $every" \
        "set vigil_timedemo_exr engine_${technique}_${seed}"
      mv "$home/.yq2/baseq2/"engine_*.exr "$scratch/pictures/"
      play_own "$technique" "$scratch/vigil.log" +set pt_seed "$seed" \
        +demomap shown "vigil_${technique}_${seed}.exr" $every +quit
      mv "$scratch/out/"vigil_*.exr "$scratch/pictures/"
      frames=$(frames_of "$scratch/engine.log")
      own=$(frames_of "$scratch/vigil.log")
      [ "$frames" = "$own" ] || die "$technique: the engine shows $frames frames, vigil $own"
    done
    step "$technique: both show $frames frames"
  done
  VIGIL_DEMO_PICTURES=$scratch/pictures VIGIL_DEMO_EVERY=$every "$build/tests/yamagi/yamagi_demo_pictures_test"
}

# 16 guards along the way from the start, and nothing else that moves.
place_guards() {
  python3 - "$data/baseq2" <<'PYTHON'
import sys
from pathlib import Path
sys.path.insert(0, "tools/quake2")
import entities
folder = Path(sys.argv[1])
entities.APART, entities.FROM_START, entities.MOST = 70.0, 150.0, 16
text = entities.entity_text(Path("baseq2/maps/warehouse.bsp")).rstrip()
places = entities.places(Path("baseq2/routes/warehouse.route"))
assert len(places) == 16
for x, y, z in places:
    text += f'\n{{\n"classname" "monster_soldier"\n"origin" "{x:.0f} {y:.0f} {z - 12:.0f}"\n"angle" "180"\n}}'
(folder / "maps/warehouse.ent").unlink()
(folder / "maps/warehouse.ent").write_text(text + "\n", encoding="latin-1")
PYTHON
}

times() {
  width=160 height=120
  headless=1 # as vigil: nothing is copied to a window
  place_guards
  record "give rocket launcher
give rockets 50
notarget
use rocket launcher" "$(waits 20; for _ in 1 2; do echo +attack; waits 10; printf '%s\n' -attack +left; waits 3
    echo -left; waits 20; printf '%s\n' +attack; waits 10; printf '%s\n' -attack +right; waits 3; echo -right; waits 20
    done)"
  local technique round
  for technique in $techniques; do
    for round in $(seq "${ROUNDS:-3}"); do
      play_engine "$technique" "$scratch/engine.log" "set flt_enable 1" "set cl_particles ${PARTICLES:-0}" \
        "set vigil_timedemo_json times.json"
      mv "$home/.yq2/baseq2/times.json" "$scratch/times_engine_${technique}_$round.json"
      play_own "$technique" "$scratch/vigil.log" +set flt_enable 1 +set timedemo_json times.json +demomap shown +quit
      mv "$scratch/out/times.json" "$scratch/times_vigil_${technique}_$round.json"
      printf '%s %s: engine %s, vigil %s\n' "$technique" "$round" \
        "$(grep -aoE '[0-9]+ frames, .* fps' "$scratch/engine.log")" \
        "$(grep -aoE '[0-9]+ frames, .* fps' "$scratch/vigil.log")"
    done
  done
  python3 - "$scratch" "$techniques" <<'PYTHON'
import json, sys
from pathlib import Path
folder, bad, parts = Path(sys.argv[1]), 0, []
for technique in sys.argv[2].split():
    medians: dict[str, dict[str, list[float]]] = {}
    for program in ("engine", "vigil"):
        for path in folder.glob(f"times_{program}_{technique}_*.json"):
            report = json.loads(path.read_text())
            for row in report["passes"] + report.get("groups", []):
                name = row["name"].removeprefix("= ").split(",")[0]
                medians.setdefault(name, {}).setdefault(program, []).append(row["median_ms"])
    # The machine's other work only adds to a run: the least of them is what the program takes.
    print(f"{technique}: median ms of a frame, least of {len(next(iter(medians.values()))['engine'])} runs\n"
          f"{'pass':<24} {'engine':>8} {'vigil':>8}  ratio")
    kept = []
    for name, rows in medians.items():
        if len(rows) < 2:
            print(f"{name:<24} {min(next(iter(rows.values()))):8.3f} of {next(iter(rows))} alone")
            continue
        engine, own = min(rows["engine"]), min(rows["vigil"])
        print(f"{name:<24} {engine:8.3f} {own:8.3f}  {engine / own:.3f}")
        kept.append({"label": name, "engine_ms": engine, "vigil_ms": own, "ratio": engine / own})
        if name in ("preparation", "path tracing") and not 0.9 < engine / own < 1.1:
            bad += 1
    parts.append({"part": technique, "rows": kept})
(folder / "times.json").write_text(json.dumps({"parts": parts}))
sys.exit(1 if bad else 0)
PYTHON
}

case $what in
  pictures) pictures ;;
  times) times ;;
  *) die "demo.sh: pictures or times" ;;
esac
