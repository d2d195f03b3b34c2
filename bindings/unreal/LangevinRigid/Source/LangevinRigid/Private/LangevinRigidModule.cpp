// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#include "LangevinRigidModule.h"

#include "HAL/PlatformProcess.h"
#include "Interfaces/IPluginManager.h"
#include "Misc/Paths.h"

#include <langevin_rigid.h>

DEFINE_LOG_CATEGORY(LogLangevinRigid);

IMPLEMENT_MODULE(FLangevinRigidModule, LangevinRigid)

namespace {
bool bLibraryAvailable = false;

constexpr uint32 Major(uint32 Version) {
    return Version >> 22;
}
constexpr uint32 Minor(uint32 Version) {
    return (Version >> 12) & 0x3ffu;
}
constexpr uint32 Patch(uint32 Version) {
    return Version & 0xfffu;
}
} // namespace

bool FLangevinRigidModule::IsCompatible(uint32 Built, uint32 Loaded) {
    return Major(Built) == Major(Loaded) && (Major(Built) != 0 || Minor(Built) == Minor(Loaded));
}

void FLangevinRigidModule::StartupModule() {
    const TSharedPtr<IPlugin> Plugin = IPluginManager::Get().FindPlugin(TEXT("LangevinRigid"));
    if (!Plugin.IsValid()) {
        UE_LOG(LogLangevinRigid, Error, TEXT("The plugin folder of LangevinRigid was not found"));
        return;
    }
    const FString ThirdParty = FPaths::Combine(Plugin->GetBaseDir(), TEXT("Source/ThirdParty/LangevinRigidLibrary"));
    const FString LibraryPath = FPaths::Combine(ThirdParty, TEXT(LANGEVIN_RIGID_LIBRARY));

    // Adds the library's own folder to the search path, only while the library is loaded.
    const FString LibraryFolder = FPaths::GetPath(LibraryPath);
    FPlatformProcess::PushDllDirectory(*LibraryFolder);
    LibraryHandle = FPlatformProcess::GetDllHandle(*LibraryPath);
    FPlatformProcess::PopDllDirectory(*LibraryFolder);
    if (LibraryHandle == nullptr) {
        const bool bExists = FPaths::FileExists(LibraryPath);
        UE_LOG(
            LogLangevinRigid, Error, TEXT("%s %s. Bodies will not be simulated."), *LibraryPath,
            bExists
                ? TEXT("is there but could not be loaded: a dependency is missing, or it is for another "
                       "processor (see the lines above, or ldd / dumpbin /dependents)")
                : TEXT("is missing: package the plugin with bindings/unreal/package.py, and in a packaged game check "
                       "that it was staged beside the executable's Plugins folder"));
        return;
    }

    const uint32 Loaded = lr_version();
    constexpr uint32 Built = LR_VERSION_MAJOR << 22 | LR_VERSION_MINOR << 12 | LR_VERSION_PATCH;
    if (!IsCompatible(Built, Loaded)) {
        UE_LOG(
            LogLangevinRigid, Error,
            TEXT(
                "%s is version %u.%u.%u, but the plugin was built for %u.%u.%u: rebuild the plugin, or put the library "
                "back that it came with. Bodies will not be simulated."),
            *LibraryPath, Major(Loaded), Minor(Loaded), Patch(Loaded), Major(Built), Minor(Built), Patch(Built));
        return;
    }
    bLibraryAvailable = true;

    int32 Targets[16] = {};
    uint32 Count = 0;
    lr_simd_targets(Targets, 16, &Count);
    UE_LOG(LogLangevinRigid, Log, TEXT("Langevin Rigid %u.%u.%u, %s"), Major(Loaded), Minor(Loaded), Patch(Loaded),
           UTF8_TO_TCHAR(lr_simd_target_name(Count > 0 ? Targets[0] : LR_SIMD_AUTO)));
}

void FLangevinRigidModule::ShutdownModule() {
    bLibraryAvailable = false;
    if (LibraryHandle != nullptr) FPlatformProcess::FreeDllHandle(LibraryHandle);
    LibraryHandle = nullptr;
}

bool FLangevinRigidModule::IsLibraryAvailable() {
    return bLibraryAvailable;
}
