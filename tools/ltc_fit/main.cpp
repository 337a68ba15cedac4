// SPDX-License-Identifier: GPL-2.0-or-later
// ltc_fit FILE: writes the table src/refresh/vkpt/light/ltc_table.bin and prints how well it
// fits. Run by hand when the GGX lobe of brdf.h or the table's layout changes; builds use the
// committed file.
#include "ltc_fit.h"

#include "common/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>

using namespace vigil;

namespace {

void write_table(const std::string& path, const std::vector<LtcFit>& table) {
    std::ofstream out(path, std::ios::binary);
    for (const LtcFit& fit : table)
        out.write(reinterpret_cast<const char*>(&fit.entry), sizeof(fit.entry));
    if (!out) fail("cannot write {}", path);
}

void print_residuals(const std::vector<LtcFit>& table) {
    fmt::print(
        "excess variance of the fit, by roughness (columns from 0.1 up) over all view angles\n");
    fmt::print("{:>10} {:>10} {:>10} {:>10}\n", "roughness", "median", "worst", "at cosine");
    for (unsigned column = 0; column < shader::LTC_TABLE_SIZE; column += 4) {
        std::vector<double> excess;
        unsigned worst = 0;
        for (unsigned row = 0; row < shader::LTC_TABLE_SIZE; ++row) {
            excess.push_back(table[row * shader::LTC_TABLE_SIZE + column].excess);
            if (excess[row] > excess[worst]) worst = row;
        }
        const double most = excess[worst];
        std::nth_element(excess.begin(), excess.begin() + 16, excess.end());
        fmt::print("{:10.3f} {:10.4f} {:10.4f} {:10.3f}\n",
                   double(column) / (shader::LTC_TABLE_SIZE - 1), excess[16], most,
                   ltc_table_view_cosine(worst));
    }
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app("Fits the table of linearly transformed cosines.", "ltc_fit");
    std::string path;
    app.add_option("FILE", path, "the table, light/ltc_table.bin")->required();
    CLI11_PARSE(app, argc, argv)
    try {
        const std::vector<LtcFit> table = fit_ltc_table();
        write_table(path, table);
        print_residuals(table);
    } catch (const Error& error) {
        fmt::print(stderr, "ltc_fit: {}\n", error.what());
        return 1;
    }
    return 0;
}
