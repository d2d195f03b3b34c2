// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"

#include "LangevinAsset.generated.h"

struct lr_asset;
class UAssetImportData;

/** An asset made by lr_bake: the bytes of a .lrb file. Drag one into the content browser. */
UCLASS(BlueprintType, HideCategories = Object)
class LANGEVINRIGID_API ULangevinAsset : public UObject {
    GENERATED_BODY()

public:
    /** Sets the bytes of a .lrb file. Returns false, and changes nothing, if they are not valid: Faults then has a line with
     * reason and remedy for each fault. */
    bool SetBytes(const TArray<uint8>& Bytes, TArray<FString>& Faults);

    const TArray<uint8>& GetBytes() const { return FileBytes; }

    /** The library's asset, created at the first call; null if the bytes are not valid. It lives as long as this object, or as
     * your own reference (lr_asset_retain). Game thread. */
    const lr_asset* GetHandle();

    /** From the origin of the mesh to the centre of mass, cm, Unreal's axes. */
    FVector GetCenterOfMass() const { return CenterOfMass; }

    virtual void PostInitProperties() override;
    virtual void PostLoad() override;
    virtual void BeginDestroy() override;

    /** Mass, g. */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Transient, Category = "Body")
    float Mass = 0.0f;

    /** Volume, cm^3. */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Transient, Category = "Body")
    float Volume = 0.0f;

    /** Largest extent, cm. */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Transient, Category = "Body")
    float Length = 0.0f;

    /** Thickness, cm. */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Transient, Category = "Body")
    float Thickness = 0.0f;

    /** Centre of mass in the frame of the mesh, cm. */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Transient, Category = "Body")
    FVector CenterOfMass = FVector::ZeroVector;

    /** Approximate fall speed in its fluid, cm/s. */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Transient, Category = "Body")
    float FallSpeed = 0.0f;

    /** Number of corners of its hull; 0: no hull. */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Transient, Category = "Body")
    int32 HullVertices = 0;

#if WITH_EDITORONLY_DATA
    UPROPERTY(VisibleAnywhere, Instanced, Category = "Import")
    TObjectPtr<UAssetImportData> AssetImportData;
#endif

private:
    void ReleaseHandle();
    void ShowInfo();

    UPROPERTY()
    TArray<uint8> FileBytes;

    lr_asset* Handle = nullptr;
};
