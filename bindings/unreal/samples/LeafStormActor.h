// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"
#include "LangevinEvents.h"

#include "LeafStormActor.generated.h"

class ULangevinAsset;
class ULangevinBatchComponent;
class UStaticMesh;

/** An endless storm of leaves: place it in a level, and set a .lrb asset and the mesh from which it was baked. */
UCLASS()
class ALeafStormActor : public AActor {
    GENERATED_BODY()

public:
    ALeafStormActor(const FObjectInitializer& ObjectInitializer);
    virtual void BeginPlay() override;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Leaf Storm")
    TObjectPtr<ULangevinAsset> Leaf;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Leaf Storm")
    TObjectPtr<UStaticMesh> LeafMesh;

    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Category = "Leaf Storm")
    TObjectPtr<ULangevinBatchComponent> Leaves;

    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Category = "Leaf Storm")
    int32 Landed = 0;

private:
    UFUNCTION()
    void CountLandings(const TArray<FLangevinEvent>& Events);
};
