// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "NiagaraDataInterface.h"

#include "NiagaraDataInterfaceLangevin.generated.h"

class AActor;
class ULangevinBatchComponent;
struct FLangevinSnapshot;

/** Reads the bodies of a batch in CPU simulations: particles on leaves, trails behind them, dust where they land. Values are from
 * the last step before the system ticks. */
UCLASS(EditInlineNew, Category = "Langevin Rigid", CollapseCategories, meta = (DisplayName = "Langevin Bodies"))
class LANGEVINRIGIDNIAGARA_API UNiagaraDataInterfaceLangevin : public UNiagaraDataInterface {
    GENERATED_BODY()

public:
    /** The actor with the batch. None: the actor of the Niagara component, or the actor to which that is attached. */
    UPROPERTY(EditAnywhere, Category = "Langevin Rigid")
    TSoftObjectPtr<AActor> Source;

    virtual void PostInitProperties() override;
    virtual void GetVMExternalFunction(const FVMExternalFunctionBindingInfo& BindingInfo, void* InstanceData,
                                       FVMExternalFunction& OutFunc) override;
    virtual bool CanExecuteOnTarget(ENiagaraSimTarget Target) const override {
        return Target == ENiagaraSimTarget::CPUSim;
    }
    virtual int32 PerInstanceDataSize() const override;
    virtual bool InitPerInstanceData(void* PerInstanceData, FNiagaraSystemInstance* SystemInstance) override;
    virtual void DestroyPerInstanceData(void* PerInstanceData, FNiagaraSystemInstance* SystemInstance) override;
    virtual bool HasPreSimulateTick() const override { return true; }
    virtual bool PerInstanceTick(void* PerInstanceData, FNiagaraSystemInstance* SystemInstance,
                                 float DeltaSeconds) override;
    virtual bool Equals(const UNiagaraDataInterface* Other) const override;

protected:
#if WITH_EDITORONLY_DATA
    virtual void GetFunctionsInternal(TArray<FNiagaraFunctionSignature>& OutFunctions) const override;
#endif
    virtual bool CopyToInternal(UNiagaraDataInterface* Destination) const override;

private:
    ULangevinBatchComponent* FindBatch(FNiagaraSystemInstance& SystemInstance) const;

    static void GetNumBodies(FVectorVMExternalFunctionContext& Context);
    static void GetBody(FVectorVMExternalFunctionContext& Context);
};
