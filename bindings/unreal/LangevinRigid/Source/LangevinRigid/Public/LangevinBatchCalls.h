// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
// The subsystem's calls to its batches. Batches know the subsystem; it knows them only by this interface.
#pragma once

#include "CoreMinimal.h"

struct FLangevinEvent;
struct lr_event;

class FLangevinBatchCalls {
public:
    virtual ~FLangevinBatchCalls() = default;

    virtual void EndBatch() = 0;

    /** Called before and after a step. */
    virtual void PrepareStep() = 0;
    /** Ahead: of the last step. Frame: since the instances were last drawn, for the bodies' places in the frame before; 0: they jump. */
    virtual void WriteInstances(double AheadSeconds, double FrameSeconds) = 0;
    virtual void WriteAllInstances() = 0;

    /** Sets the batch in an event of one of its bodies. */
    virtual void NameBatch(const lr_event& From, FLangevinEvent& Event) = 0;
};
