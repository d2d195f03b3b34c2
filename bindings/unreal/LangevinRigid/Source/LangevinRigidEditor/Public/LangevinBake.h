// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Kismet/BlueprintFunctionLibrary.h"

#include "LangevinBake.generated.h"

class ULangevinAsset;
class UStaticMesh;

/** Bakes static meshes in the editor, by the lr_bake of the plugin: in the content browser's menu of a mesh, from Blueprints, and from
 * Python as unreal.LangevinBake.bake_static_mesh(mesh, 350, 0). */
UCLASS()
class LANGEVINRIGIDEDITOR_API ULangevinBake : public UBlueprintFunctionLibrary {
    GENERATED_BODY()

public:
    /**
     * Bakes a mesh into the asset MESH_Langevin beside it, in place of an earlier one. Null after an error, which the log explains.
     *
     * @param Density         kg/m^3: dry leaves 350, paper and petals 800
     * @param SheetThickness  cm: the mesh is the middle surface of a sheet. 0: it is the body's surface
     */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid")
    static ULangevinAsset* BakeStaticMesh(UStaticMesh* Mesh, float Density = 350.0f, float SheetThickness = 0.0f);

    /** The mesh as an OBJ file in the library's frame: metres, right-handed, Z up. Empty without triangles. */
    static FString WriteObj(UStaticMesh& Mesh);
};
