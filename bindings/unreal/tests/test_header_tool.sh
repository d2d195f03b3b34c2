#!/usr/bin/env bash
# Headers with one fault each must be refused: test_header_tool.sh BUILD_DIR
# SPDX-License-Identifier: MIT
set -euo pipefail
tool="$(cd "$(dirname "${BASH_SOURCE[0]}")/../shim" && pwd)/header_tool.py"
rm -rf "$1"
mkdir -p "$1"
cd "$1"
good='#include "A.generated.h"
UCLASS()
class UA : public UObject {
    GENERATED_BODY()
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "A")
    int32 Count = 0;
    UFUNCTION(BlueprintCallable)
    int32 Add(const TArray<FVector>& Points, float Scale = 1.0f);
};'
printf '%s\n' "$good" >A.h
python3 "$tool" out A.h
refuse() { # SED WANTED
    sed "$1" <<<"$good" >A.h
    if python3 "$tool" out A.h 2>errors.txt; then echo "not refused: $1"; exit 1; fi
    grep -q "$2" errors.txt || { cat errors.txt; exit 1; }
}
refuse 's/A.generated.h/B.h/' 'must be the last include'
refuse 's/int32 Count/uint32 Count/' 'not supported by blueprint'
refuse 's/float Scale/uint64 Scale/' 'not supported by blueprint'
refuse 's/, Category = "A"//' 'needs a Category'
refuse 's/class UA/class FA/' 'begin with U or A'
echo "header tool: 5 faults refused"
