// SPDX-License-Identifier: GPL-2.0-or-later
// For GPU tests under sanitizers and the programs they start: drivers and layers stay loaded to the
// end, so that what they keep is known to be theirs (tests/lsan.supp goes by their names).
extern "C" int dlclose(void*) {
    return 0;
}
