// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Modules/ModuleManager.h"

LANGEVINRIGID_API DECLARE_LOG_CATEGORY_EXTERN(LogLangevinRigid, Log, All);

class LANGEVINRIGID_API FLangevinRigidModule : public IModuleInterface {
public:
    virtual void StartupModule() override;
    virtual void ShutdownModule() override;

    /** Whether the native library is loaded and has the version that the plugin was built for. Otherwise none of its
     * functions may be called: on Windows the first call would end the process. */
    static bool IsLibraryAvailable();

    /** Whether a library of version Loaded works with a plugin built for version Built (lr_version). */
    static bool IsCompatible(uint32 Built, uint32 Loaded);

private:
    void* LibraryHandle = nullptr;
};
