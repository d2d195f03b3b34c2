// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#include "LangevinAsset.h"

#include "LangevinConversion.h"
#include "LangevinHost.h"
#include "LangevinRigidModule.h"

#if WITH_EDITORONLY_DATA
#include "EditorFramework/AssetImportData.h"
#endif

#include <langevin_rigid.h>

bool ULangevinAsset::SetBytes(const TArray<uint8>& Bytes, TArray<FString>& Faults) {
    if (!FLangevinRigidModule::IsLibraryAvailable()) {
        Faults.Add(TEXT("The native library is not loaded; the log says why."));
        return false;
    }
    const auto Report = [](void* User, uint32 Number, const char* Where, const char* What, const char* Remedy) {
        static_cast<TArray<FString>*>(User)->Add(FString::Printf(TEXT("%u at %s: %s. %s"), Number, UTF8_TO_TCHAR(Where),
                                                                 UTF8_TO_TCHAR(What), UTF8_TO_TCHAR(Remedy)));
    };
    const lr_status Status = lr_asset_check_memory(Bytes.GetData(), static_cast<uint64>(Bytes.Num()), Report, &Faults);
    if (Status != LR_OK) {
        if (Faults.Num() == 0) Faults.Add(UTF8_TO_TCHAR(lr_status_string(Status)));
        return false;
    }
    ReleaseHandle();
    FileBytes = Bytes;
    ShowInfo();
    return true;
}

const lr_asset* ULangevinAsset::GetHandle() {
    if (Handle == nullptr && FileBytes.Num() > 0 && FLangevinRigidModule::IsLibraryAvailable()) {
        const lr_status Status =
            lr_asset_load_memory(FileBytes.GetData(), static_cast<uint64>(FileBytes.Num()), &Handle);
        if (Status != LR_OK) {
            UE_LOG(LogLangevinRigid, Error, TEXT("%s: %s. Import the .lrb file again."), *GetPathName(),
                   UTF8_TO_TCHAR(lr_status_string(Status)));
        }
    }
    return Handle;
}

void ULangevinAsset::PostInitProperties() {
#if WITH_EDITORONLY_DATA
    if (!HasAnyFlags(RF_ClassDefaultObject)) {
        AssetImportData = NewObject<UAssetImportData>(this, TEXT("AssetImportData"));
    }
#endif
    Super::PostInitProperties();
}

void ULangevinAsset::PostLoad() {
    Super::PostLoad();
    ShowInfo();
}

void ULangevinAsset::BeginDestroy() {
    ReleaseHandle();
    Super::BeginDestroy();
}

void ULangevinAsset::ReleaseHandle() {
    if (Handle != nullptr && FLangevinRigidModule::IsLibraryAvailable()) lr_asset_release(Handle);
    Handle = nullptr;
}

void ULangevinAsset::ShowInfo() {
    lr_asset_info Info = {};
    Info.struct_size = sizeof(Info);
    const lr_asset* Asset = GetHandle();
    if (Asset == nullptr || lr_asset_get_info(Asset, &Info) != LR_OK) return;
    const double Cubic = FMath::Pow(LangevinConversion::CentimetresPerMetre, 3.0);
    Mass = static_cast<float>(Info.mass * 1000.0);
    Volume = static_cast<float>(Info.volume * Cubic);
    Length = static_cast<float>(LangevinConversion::LengthToCentimetres(Info.length_d));
    Thickness = static_cast<float>(LangevinConversion::LengthToCentimetres(Info.length_b));
    FallSpeed = static_cast<float>(LangevinConversion::LengthToCentimetres(Info.u0));
    HullVertices = static_cast<int32>(Info.hull_vertex_count);
    const LangevinConversion::FVec Center =
        LangevinConversion::VectorToUnreal({Info.center_of_mass[0], Info.center_of_mass[1], Info.center_of_mass[2]});
    CenterOfMass = FVector(Center.X, Center.Y, Center.Z);
}
