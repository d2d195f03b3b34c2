#include <langevin_rigid_baker.hpp>

int main() {
    return langevin_rigid::BakeResult{} ? 1 : 0;
}
