/* An exception is thrown and caught within the library: out_of_memory FILE, which does not fit into memory. */
#include <langevin_rigid.h>
#include <stdio.h>

int main(int count, char** arguments) {
    lr_asset* asset = NULL;
    if (count != 2 || lr_asset_load_file(arguments[1], &asset) != LR_ERROR_OUT_OF_MEMORY) {
        fprintf(stderr, "out_of_memory: %s\n", lr_last_error());
        return 1;
    }
    return 0;
}
