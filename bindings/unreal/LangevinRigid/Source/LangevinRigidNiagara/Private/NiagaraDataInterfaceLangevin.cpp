// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#include "NiagaraDataInterfaceLangevin.h"

#include "GameFramework/Actor.h"
#include "LangevinBatchComponent.h"
#include "NiagaraSystemInstance.h"
#include "NiagaraTypes.h"

namespace {
const FName GetNumBodiesName(TEXT("GetNumBodies"));
const FName GetBodyName(TEXT("GetBody"));

/** A copy for simulations, which run on other threads. */
struct FInstanceData {
    TWeakObjectPtr<ULangevinBatchComponent> Batch;
    TSharedPtr<const FLangevinSnapshot, ESPMode::ThreadSafe> Snapshot;
    FNiagaraLWCConverter Converter;
};
} // namespace

void UNiagaraDataInterfaceLangevin::PostInitProperties() {
    Super::PostInitProperties();
    if (HasAnyFlags(RF_ClassDefaultObject)) {
        const ENiagaraTypeRegistryFlags Flags =
            ENiagaraTypeRegistryFlags::AllowAnyVariable | ENiagaraTypeRegistryFlags::AllowParameter;
        FNiagaraTypeRegistry::Register(FNiagaraTypeDefinition(GetClass()), Flags);
    }
}

#if WITH_EDITORONLY_DATA
void UNiagaraDataInterfaceLangevin::GetFunctionsInternal(TArray<FNiagaraFunctionSignature>& OutFunctions) const {
    FNiagaraFunctionSignature Signature;
    Signature.bMemberFunction = true;
    Signature.bRequiresContext = false;
    Signature.bSupportsGPU = false;
    Signature.Inputs.Add(FNiagaraVariable(FNiagaraTypeDefinition(GetClass()), FName(TEXT("Bodies"))));

    FNiagaraFunctionSignature Count = Signature;
    Count.Name = GetNumBodiesName;
    Count.Outputs.Add(FNiagaraVariable(FNiagaraTypeDefinition::GetIntDef(), FName(TEXT("Num"))));
    Count.Outputs.Add(FNiagaraVariable(FNiagaraTypeDefinition::GetIntDef(), FName(TEXT("Num Awake"))));
    OutFunctions.Add(Count);

    FNiagaraFunctionSignature Body = Signature;
    Body.Name = GetBodyName;
    Body.Inputs.Add(FNiagaraVariable(FNiagaraTypeDefinition::GetIntDef(), FName(TEXT("Index"))));
    Body.Outputs.Add(FNiagaraVariable(FNiagaraTypeDefinition::GetBoolDef(), FName(TEXT("Valid"))));
    Body.Outputs.Add(FNiagaraVariable(FNiagaraTypeDefinition::GetPositionDef(), FName(TEXT("Position"))));
    Body.Outputs.Add(FNiagaraVariable(FNiagaraTypeDefinition::GetQuatDef(), FName(TEXT("Orientation"))));
    Body.Outputs.Add(FNiagaraVariable(FNiagaraTypeDefinition::GetVec3Def(), FName(TEXT("Velocity"))));
    Body.Outputs.Add(FNiagaraVariable(FNiagaraTypeDefinition::GetVec3Def(), FName(TEXT("Angular Velocity"))));
    Body.Outputs.Add(FNiagaraVariable(FNiagaraTypeDefinition::GetFloatDef(), FName(TEXT("Age"))));
    Body.Outputs.Add(FNiagaraVariable(FNiagaraTypeDefinition::GetFloatDef(), FName(TEXT("Scale"))));
    OutFunctions.Add(Body);
}
#endif

void UNiagaraDataInterfaceLangevin::GetVMExternalFunction(const FVMExternalFunctionBindingInfo& BindingInfo, void*,
                                                          FVMExternalFunction& OutFunc) {
    if (BindingInfo.Name == GetNumBodiesName) {
        OutFunc = FVMExternalFunction::CreateStatic(&UNiagaraDataInterfaceLangevin::GetNumBodies);
    } else if (BindingInfo.Name == GetBodyName) {
        OutFunc = FVMExternalFunction::CreateStatic(&UNiagaraDataInterfaceLangevin::GetBody);
    }
}

int32 UNiagaraDataInterfaceLangevin::PerInstanceDataSize() const {
    return sizeof(FInstanceData);
}

bool UNiagaraDataInterfaceLangevin::InitPerInstanceData(void* PerInstanceData, FNiagaraSystemInstance* SystemInstance) {
    FInstanceData* Data = new (PerInstanceData) FInstanceData;
    Data->Converter = SystemInstance->GetLWCConverter(false);
    Data->Batch = FindBatch(*SystemInstance);
    return true; // a batch can still be created
}

void UNiagaraDataInterfaceLangevin::DestroyPerInstanceData(void* PerInstanceData, FNiagaraSystemInstance*) {
    static_cast<FInstanceData*>(PerInstanceData)->~FInstanceData();
}

// Returns whether the instance must restart: never.
bool UNiagaraDataInterfaceLangevin::PerInstanceTick(void* PerInstanceData, FNiagaraSystemInstance* SystemInstance,
                                                    float) {
    FInstanceData& Data = *static_cast<FInstanceData*>(PerInstanceData);
    if (!Data.Batch.IsValid()) Data.Batch = FindBatch(*SystemInstance);
    Data.Converter = SystemInstance->GetLWCConverter(false);
    Data.Snapshot.Reset();
    if (const ULangevinBatchComponent* Batch = Data.Batch.Get()) Data.Snapshot = Batch->GetSnapshot();
    return false;
}

ULangevinBatchComponent* UNiagaraDataInterfaceLangevin::FindBatch(FNiagaraSystemInstance& SystemInstance) const {
    if (const AActor* Actor = Source.Get()) return Actor->FindComponentByClass<ULangevinBatchComponent>();
    for (USceneComponent* Component = SystemInstance.GetAttachComponent(); Component != nullptr;
         Component = Component->GetAttachParent()) {
        if (ULangevinBatchComponent* Batch = Cast<ULangevinBatchComponent>(Component)) return Batch;
        const AActor* Owner = Component->GetOwner();
        if (Owner == nullptr) continue;
        if (ULangevinBatchComponent* Batch = Owner->FindComponentByClass<ULangevinBatchComponent>()) return Batch;
    }
    return nullptr;
}

bool UNiagaraDataInterfaceLangevin::Equals(const UNiagaraDataInterface* Other) const {
    return Super::Equals(Other) && CastChecked<UNiagaraDataInterfaceLangevin>(Other)->Source == Source;
}

bool UNiagaraDataInterfaceLangevin::CopyToInternal(UNiagaraDataInterface* Destination) const {
    if (!Super::CopyToInternal(Destination)) return false;
    CastChecked<UNiagaraDataInterfaceLangevin>(Destination)->Source = Source;
    return true;
}

void UNiagaraDataInterfaceLangevin::GetNumBodies(FVectorVMExternalFunctionContext& Context) {
    VectorVM::FUserPtrHandler<FInstanceData> Data(Context);
    FNDIOutputParam<int32> OutNum(Context);
    FNDIOutputParam<int32> OutAwake(Context);
    const FLangevinSnapshot* Snapshot = Data->Snapshot.Get();
    for (int32 Instance = 0; Instance < Context.GetNumInstances(); ++Instance) {
        OutNum.SetAndAdvance(Snapshot != nullptr ? Snapshot->Num() : 0);
        OutAwake.SetAndAdvance(Snapshot != nullptr ? Snapshot->AwakeCount : 0);
    }
}

void UNiagaraDataInterfaceLangevin::GetBody(FVectorVMExternalFunctionContext& Context) {
    VectorVM::FUserPtrHandler<FInstanceData> Data(Context);
    FNDIInputParam<int32> InIndex(Context);
    FNDIOutputParam<bool> OutValid(Context);
    FNDIOutputParam<FVector3f> OutPosition(Context);
    FNDIOutputParam<FQuat4f> OutOrientation(Context);
    FNDIOutputParam<FVector3f> OutVelocity(Context);
    FNDIOutputParam<FVector3f> OutSpin(Context);
    FNDIOutputParam<float> OutAge(Context);
    FNDIOutputParam<float> OutScale(Context);
    const FLangevinSnapshot* Snapshot = Data->Snapshot.Get();
    for (int32 Instance = 0; Instance < Context.GetNumInstances(); ++Instance) {
        const int32 Index = InIndex.GetAndAdvance();
        const bool bValid = Snapshot != nullptr && Index >= 0 && Index < Snapshot->Num();
        OutValid.SetAndAdvance(bValid);
        OutPosition.SetAndAdvance(
            bValid ? FVector3f(Data->Converter.ConvertWorldToSimulationPosition(Snapshot->Locations[Index]))
                   : FVector3f::ZeroVector);
        OutOrientation.SetAndAdvance(bValid ? Snapshot->Rotations[Index] : FQuat4f::Identity);
        OutVelocity.SetAndAdvance(bValid ? Snapshot->Velocities[Index] : FVector3f::ZeroVector);
        OutSpin.SetAndAdvance(bValid ? Snapshot->Spins[Index] : FVector3f::ZeroVector);
        OutAge.SetAndAdvance(bValid ? Snapshot->Ages[Index] : 0.0f);
        OutScale.SetAndAdvance(bValid ? Snapshot->Scales[Index] : 0.0f);
    }
}
