// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
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
    /** The emitter spawned the body. */
    Spawned = 1,
    /** The body began to touch a collider. */
    Hit = 2,
    /** The body stopped touching the collider. */
    Lifted = 3,
    /** The body fell asleep by itself. */
    Landed = 4,
    Woke = 5,
    /** The rules of its batch destroyed the body. */
    Ended = 6,
    /** The rules of its batch ended the body, and the emitter respawned it. */
    Respawned = 7,
    /** The body diverged, and is held, destroyed or respawned; then there is also Ended or Respawned. */
    Diverged = 8,
};

USTRUCT(BlueprintType)
struct LANGEVINRIGID_API FLangevinEvent {
    GENERATED_BODY()

    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    ELangevinEvent Kind = ELangevinEvent::None;

    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    FLangevinBody Body;

    /** The body's user number. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    int64 User = 0;

    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    TObjectPtr<ULangevinBatchComponent> Batch;

    /** The touched component; null for planes and for other events. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    TObjectPtr<UPrimitiveComponent> Other;

    /** The contact point, or else the body's location, cm, world. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    FVector Location = FVector::ZeroVector;

    /** Unit normal from the collider to the body. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    FVector Normal = FVector::ZeroVector;

    /** Approach speed, cm/s. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    float Speed = 0.0f;

    /** Impulse along the normal, kg cm/s. */
    UPROPERTY(BlueprintReadOnly, Category = "Langevin Rigid")
    float Impulse = 0.0f;
};

/** All events of a step at once: thousands of leaves can land in a frame. */
DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FLangevinEvents, const TArray<FLangevinEvent>&, Events);
