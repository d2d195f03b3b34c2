// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Templates/UniquePtr.h"

class FArchive;
struct lr_world;

/** Records every call on a world to a file, for lr_replay. */
class FLangevinRecording {
public:
    /** Null, after a message, if the file cannot be written. The recording must outlive the world, or stop before its end. */
    static TUniquePtr<FLangevinRecording> Start(lr_world* World, const FString& Filename);
    ~FLangevinRecording();

    /** False if the file is incomplete: its contents end before the error. */
    bool Stop(lr_world* World);

private:
    explicit FLangevinRecording(FArchive* InFile);
    static int32 Append(void* User, const void* Bytes, uint64_t Size);

    TUniquePtr<FArchive> File;
};
