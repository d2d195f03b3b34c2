#include "baker/added_mass/single_cholesky.h"

#include <doctest/doctest.h>

using namespace lr::baker;

TEST_CASE("Cholesky in single precision solves to single precision, at every size around its tiles") {
    for (const Eigen::Index n : {1, 2, 31, 32, 33, 64, 95, 97, 130, 257, 300, 601}) {
        CAPTURE(n);
        Eigen::MatrixXd matrix(n, n), exact(n, 9);
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index j = 0; j < n; ++j)
                matrix(i, j) = 1.0 / (1.0 + static_cast<double>((i - j) * (i - j))) + (i == j ? 1.0 : 0.0);
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index k = 0; k < 9; ++k) exact(i, k) = static_cast<double>((7 * i + 3 * k) % 11) - 5.0;
        SingleCholesky factor;
        REQUIRE(factor.factorise(matrix));
        Eigen::MatrixXd x = matrix * exact;
        factor.solve(x);
        CHECK((x - exact).cwiseAbs().maxCoeff() < 2e-5);
        matrix(n / 2, n / 2) = -1.0;
        CHECK_FALSE(factor.factorise(matrix));
    }
}
