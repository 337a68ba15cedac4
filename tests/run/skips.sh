#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Skips are found in the results of ctest and GoogleTest, and judged by the list of continuous integration.
# shellcheck source-path=SCRIPTDIR source=check.sh
source "$(dirname "${BASH_SOURCE[0]}")/check.sh"

mkdir "$scratch/unit" "$scratch/gpu"
cat >"$scratch/unit/cvar_test.xml" <<'XML'
<testsuite name="A" tests="3" failures="0" disabled="0" skipped="2">
  <testcase name="B"><skipped message="/x/cvar_test.cpp:54&#x0A;no range&#x0A;"><![CDATA[/x/cvar_test.cpp:54]]></skipped>
  <testcase name="C"><skipped message="/x/cvar_test.cpp:54&#x0A;no range&#x0A;"><![CDATA[/x/cvar_test.cpp:54]]></skipped>
XML
echo "cvar_test passed" >"$scratch/unit/ctest"
printf '%s\n' "trace_test passed" "numerics_page skipped" >"$scratch/gpu/ctest"
echo '<skipped message="SKIP_RETURN_CODE=77">' >"$scratch/gpu/junit.xml"

expect $'no range\nno range\nall of numerics_page' skip_reasons "$scratch/unit" "$scratch/gpu"
judge() { skip_reasons "$@" | judge_skips .ci/skips; }
expect "" judge "$scratch/unit"
refuses "1 all of numerics_page" judge "$scratch/unit" "$scratch/gpu"

# A capability that was lost: the reason is on no list.
cat >"$scratch/unit/window_test.xml" <<'XML'
  <testcase name="D"><skipped message="/x/window_test.cpp:41&#x0A;needs Xvfb &amp; xdotool&#x0A;">
XML
refuses "1 needs Xvfb & xdotool" judge "$scratch/unit"
# A longer reason than an allowed one is another reason.
echo '<skipped message="/x/a.cpp:1&#x0A;no range of GPUs&#x0A;">' >"$scratch/unit/window_test.xml"
refuses "no range of GPUs" judge "$scratch/unit"

# Every allowed reason is still in the sources: no dead rows.
while read -r reason; do
  grep -rqF "GTEST_SKIP() << \"$reason\"" tests || failed "no test skips because of '$reason'"
done < <(grep -v '^\(#\|$\)' .ci/skips)

# What the test of the pages asks for is what the capability asks for.
imports=$(grep -o "import flip_evaluator[^\"']*" tools/run/skips.sh)
grep -qF "\"$imports\"" tests/bench/experiments_test.cpp || failed "the pages' test does not ask for '$imports'"

VIGIL_CAPABILITIES="levels no_such_thing" refuses "no capability no_such_thing" demand_capabilities
play python3 <<<'exit 1'
VIGIL_CAPABILITIES=pages refuses "cannot: pages" demand_capabilities
