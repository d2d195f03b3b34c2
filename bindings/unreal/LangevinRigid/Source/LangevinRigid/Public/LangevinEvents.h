// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"

#include "LangevinEvents.generated.h"

class ULangevinBatchComponent;
class UPrimitiveComponent;

/** A body handle: fixed while the body lives, and detected as stale afterwards. */
USTRUCT(BlueprintType)
struct LANGEVINRIGID_API FLangevinBody {
    GENERATED_BODY()

    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    int64 Id = 0;
};

UENUM(BlueprintType)
enum class ELangevinEvent : uint8 {
    None = 0,
    /** An emitter added the body. */
    Spawned = 1,
    /** It touches a collider that it did not touch before. */
    Hit = 2,
    /** It no longer touches the collider. */
    Lifted = 3,
    /** It fell asleep by itself. */
    Landed = 4,
    Woke = 5,
    /** The rules of its batch destroyed it. */
    Ended = 6,
    /** The rules of its batch ended it, and it restarted. */
    Respawned = 7,
    /** It diverged, and is held where it was or has ended; then there is Ended or Respawned too. */
    Diverged = 8,
};

USTRUCT(BlueprintType)
struct LANGEVINRIGID_API FLangevinEvent {
    GENERATED_BODY()

    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    ELangevinEvent Kind = ELangevinEvent::None;

    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    FLangevinBody Body;

    /** The number that the program gave to the body. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    int64 User = 0;

    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    TObjectPtr<ULangevinBatchComponent> Batch;

    /** The component touched; null for planes and if there is none. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    TObjectPtr<UPrimitiveComponent> Other;

    /** cm, world: where they touch, else of the body. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    FVector Location = FVector::ZeroVector;

    /** From the collider to the body. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    FVector Normal = FVector::ZeroVector;

    /** cm/s, approach speed. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    float Speed = 0.0f;

    /** kg cm/s, along the normal. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    float Impulse = 0.0f;
};

/** All events of a step at once: thousands of leaves may land in a frame. */
DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FLangevinEvents, const TArray<FLangevinEvent>&, Events);
