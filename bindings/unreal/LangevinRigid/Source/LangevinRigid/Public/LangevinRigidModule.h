// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Modules/ModuleManager.h"

LANGEVINRIGID_API DECLARE_LOG_CATEGORY_EXTERN(LogLangevinRigid, Log, All);

class LANGEVINRIGID_API FLangevinRigidModule : public IModuleInterface {
public:
    virtual void StartupModule() override;
    virtual void ShutdownModule() override;

    /** Whether the native library is loaded and of the version that the plugin was built for. Without it no function of
        it may be called: on Windows the first call would end the process. */
    static bool IsLibraryAvailable();

    /** Whether a library of version Loaded serves a plugin that was built with version Built (lr_version). */
    static bool IsCompatible(uint32 Built, uint32 Loaded);

private:
    void* LibraryHandle = nullptr;
};
