// SPDX-License-Identifier: MIT
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
    /** Takes the bytes of a .lrb file. Returns false, and changes nothing, if they are not one: Faults then says why, a line
        for each, with what to do. */
    bool SetBytes(const TArray<uint8>& Bytes, TArray<FString>& Faults);

    const TArray<uint8>& GetBytes() const { return FileBytes; }

    /** The asset of the library, made when first asked for; null if the bytes are none. It lives as long as this object, or as
        a reference of one's own (lr_asset_retain). Game thread. */
    const lr_asset* GetHandle();

    /** cm, Unreal's axes: from the origin of the mesh to the centre of mass. */
    FVector GetCenterOfMass() const { return CenterOfMass; }

    virtual void PostInitProperties() override;
    virtual void PostLoad() override;
    virtual void BeginDestroy() override;

    /** g */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Transient, Category = "Body")
    float Mass = 0.0f;

    /** cm^3 */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Transient, Category = "Body")
    float Volume = 0.0f;

    /** cm, the largest extent. */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Transient, Category = "Body")
    float Length = 0.0f;

    /** cm */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Transient, Category = "Body")
    float Thickness = 0.0f;

    /** cm, in the mesh. */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Transient, Category = "Body")
    FVector CenterOfMass = FVector::ZeroVector;

    /** cm/s, approximate fall speed in its fluid. */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Transient, Category = "Body")
    float FallSpeed = 0.0f;

    /** Corners of its hull, 0 for none. */
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
