// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"

#include "LangevinEvents.generated.h"

class ULangevinBatchComponent;
class UPrimitiveComponent;

/** One body: a value that stays the same as long as it lives, and is recognised when it no longer does. */
USTRUCT(BlueprintType)
struct LANGEVINRIGID_API FLangevinBody {
    GENERATED_BODY()

    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    int64 Id = 0;
};

UENUM(BlueprintType)
enum class ELangevinContact : uint8 {
    None = 0,
    /** A body touches a collider that it did not touch before. */
    Begin = 1,
    End = 2,
    /** It has come to rest. */
    Landed = 3,
    /** It has left rest. */
    Woke = 4,
    /** The rules of its batch have ended it, or let it begin anew. */
    Ended = 5,
    /** It has left physics, and is held where it was, or has ended for it: then there is Ended too. */
    Faulted = 6,
};

USTRUCT(BlueprintType)
struct LANGEVINRIGID_API FLangevinContactEvent {
    GENERATED_BODY()

    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    ELangevinContact Kind = ELangevinContact::None;

    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    FLangevinBody Body;

    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    TObjectPtr<ULangevinBatchComponent> Batch;

    /** What was touched; null for planes, and where nothing was. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    TObjectPtr<UPrimitiveComponent> Other;

    /** cm, world: where they touch, else of the body. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    FVector Location = FVector::ZeroVector;

    /** From what was touched to the body. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    FVector Normal = FVector::ZeroVector;

    /** cm/s, at which they met. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    float Speed = 0.0f;

    /** kg cm/s, along the normal. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    float Impulse = 0.0f;
};

/** All of a step at once: thousands of leaves land in a frame. */
DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FLangevinContactEvents, const TArray<FLangevinContactEvent>&, Events);
