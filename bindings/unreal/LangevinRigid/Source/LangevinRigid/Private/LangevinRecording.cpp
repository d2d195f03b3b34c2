// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#include "LangevinRecording.h"

#include "HAL/FileManager.h"
#include "LangevinHost.h"
#include "LangevinRigidModule.h"
#include "Serialization/Archive.h"

#include <langevin_rigid.h>

TUniquePtr<FLangevinRecording> FLangevinRecording::Start(lr_world* World, const FString& Filename) {
    FArchive* const File = IFileManager::Get().CreateFileWriter(*Filename, FILEWRITE_AllowRead);
    if (File == nullptr) {
        UE_LOG(LogLangevinRigid, Error, TEXT("Recording: %s cannot be written"), *Filename);
        return nullptr;
    }
    TUniquePtr<FLangevinRecording> Made(new FLangevinRecording(File));
    lr_recording_desc Desc;
    lr_recording_desc_init(&Desc, sizeof(Desc));
    Desc.hash_interval = 10; // hashing every step would be most of the cost of a recording
    Desc.write = &FLangevinRecording::Append;
    Desc.user = Made.Get();
    if (!LangevinHost::Check(lr_world_record_start(World, &Desc), TEXT("A recording"))) return nullptr;
    return Made;
}

FLangevinRecording::FLangevinRecording(FArchive* InFile) : File(InFile) {}
FLangevinRecording::~FLangevinRecording() = default;

bool FLangevinRecording::Stop(lr_world* World) {
    const bool bWhole = lr_world_record_stop(World) == LR_OK;
    return File->Close() && bWhole;
}

// Called inside the library's calls, by one thread at a time. Flushed at once: after a crash the last call matters most.
int32 FLangevinRecording::Append(void* User, const void* Bytes, uint64_t Size) {
    FArchive& File = *static_cast<FLangevinRecording*>(User)->File;
    File.Serialize(const_cast<void*>(Bytes), static_cast<int64>(Size));
    File.Flush();
    return File.IsError() ? 1 : 0;
}
