// The calls that the subsystem makes to its batches. They know the subsystem; it knows them by this interface alone.
// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"

struct FLangevinEvent;
struct lr_event;

class FLangevinBatchCalls {
public:
    virtual ~FLangevinBatchCalls() = default;

    virtual void EndBatch() = 0;

    /** Before a step, and after one. */
    virtual void PrepareStep() = 0;
    virtual void WriteInstances(double AheadSeconds) = 0;
    virtual void WriteAllInstances() = 0;

    /** Names the batch in an event of one of its bodies. */
    virtual void NameBatch(const lr_event& From, FLangevinEvent& Event) = 0;
};
