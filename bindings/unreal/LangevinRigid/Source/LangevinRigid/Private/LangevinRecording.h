// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Templates/UniquePtr.h"

class FArchive;
struct lr_world;

/** A file that takes every call on a world, for lr_replay. */
class FLangevinRecording {
public:
    /** Null, after a message, where the file cannot be written. Outlive the world, or stop first. */
    static TUniquePtr<FLangevinRecording> Start(lr_world* World, const FString& Filename);
    ~FLangevinRecording();

    /** False where the file could not take all of it: it then holds what came before. */
    bool Stop(lr_world* World);

private:
    explicit FLangevinRecording(FArchive* InFile);
    static int32 Append(void* User, const void* Bytes, uint64_t Size);

    TUniquePtr<FArchive> File;
};
