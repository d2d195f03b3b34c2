// Stand-ins for the parts of Niagara and VectorVM that the plugin uses. SPDX-License-Identifier: MIT
#pragma once

#include "engine.h"

enum class ENiagaraSimTarget : uint8 { CPUSim, GPUComputeSim };
enum class ENiagaraTypeRegistryFlags : uint32 {
    None = 0,
    AllowUserVariable = 1,
    AllowAnyVariable = 0xf,
    AllowParameter = 0x10
};
inline ENiagaraTypeRegistryFlags operator|(ENiagaraTypeRegistryFlags A, ENiagaraTypeRegistryFlags B) {
    return static_cast<ENiagaraTypeRegistryFlags>(static_cast<uint32>(A) | static_cast<uint32>(B));
}

class FNiagaraTypeDefinition {
public:
    explicit FNiagaraTypeDefinition(UClass* InClass) : Class(InClass) {}
    static const FNiagaraTypeDefinition& GetIntDef();
    static const FNiagaraTypeDefinition& GetBoolDef();
    static const FNiagaraTypeDefinition& GetFloatDef();
    static const FNiagaraTypeDefinition& GetVec3Def();
    static const FNiagaraTypeDefinition& GetQuatDef();
    static const FNiagaraTypeDefinition& GetPositionDef();
    int32 ShimRegisters() const { return Registers; }
    UClass* GetClass() const { return Class; }

private:
    explicit FNiagaraTypeDefinition(int32 InRegisters) : Registers(InRegisters) {}
    UClass* Class = nullptr;
    int32 Registers = 0;
};

struct FNiagaraTypeRegistry {
    static void Register(const FNiagaraTypeDefinition& NewType, ENiagaraTypeRegistryFlags Flags);
    static TArray<UClass*> ShimRegistered;
};

class FNiagaraVariable {
public:
    FNiagaraVariable(const FNiagaraTypeDefinition& InType, const FName& InName) : Type(InType), Name(InName) {}
    const FNiagaraTypeDefinition& GetType() const { return Type; }
    const FName& GetName() const { return Name; }

private:
    FNiagaraTypeDefinition Type;
    FName Name;
};

struct FNiagaraFunctionSignature {
    FName Name;
    TArray<FNiagaraVariable> Inputs;
    TArray<FNiagaraVariable> Outputs;
    uint32 bMemberFunction : 1 = 0;
    uint32 bRequiresContext : 1 = 1;
    uint32 bSupportsCPU : 1 = 1;
    uint32 bSupportsGPU : 1 = 1;
};

struct FVMExternalFunctionBindingInfo {
    FName Name;
};

/** A call for several particles: a register has a value for each. */
struct FVectorVMExternalFunctionContext {
    int32 GetNumInstances() const { return ShimInstances; }

    int32 ShimInstances = 0;
    void* ShimUserPtr = nullptr;
    std::vector<std::vector<uint32>> ShimInputs, ShimOutputs;
    std::size_t ShimNextInput = 0, ShimNextOutput = 0;
    uint32* ShimInput() { return ShimInputs.at(ShimNextInput++).data(); }
    uint32* ShimOutput() {
        ShimOutputs.resize(++ShimNextOutput);
        ShimOutputs.back().resize(static_cast<std::size_t>(ShimInstances));
        return ShimOutputs.back().data();
    }
};
using FVMExternalFunction = TDelegate<void(FVectorVMExternalFunctionContext&)>;

namespace VectorVM {
template <typename T> struct FUserPtrHandler {
    explicit FUserPtrHandler(FVectorVMExternalFunctionContext& Context) : Ptr(static_cast<T*>(Context.ShimUserPtr)) {}
    T* Get() { return Ptr; }
    T* operator->() { return Ptr; }

private:
    T* Ptr;
};
} // namespace VectorVM

template <typename T> struct FNDIInputParam {
    explicit FNDIInputParam(FVectorVMExternalFunctionContext& Context) : Data(Context.ShimInput()) {}
    T GetAndAdvance() {
        T Value;
        std::memcpy(&Value, Data++, sizeof(Value));
        return Value;
    }

private:
    uint32* Data;
};
template <typename T> struct FNDIOutputParam {
    explicit FNDIOutputParam(FVectorVMExternalFunctionContext& Context) {
        for (uint32*& Register : Registers) Register = Context.ShimOutput();
    }
    void SetAndAdvance(T Value) {
        if constexpr (std::is_same_v<T, bool>) {
            *Registers[0]++ = Value ? 0xffffffffu : 0u;
        } else {
            for (std::size_t Part = 0; Part < Count; ++Part) {
                std::memcpy(Registers[Part]++, reinterpret_cast<const char*>(&Value) + 4 * Part, 4);
            }
        }
    }

private:
    static constexpr std::size_t Count = std::is_same_v<T, bool> ? 1 : sizeof(T) / 4;
    uint32* Registers[Count];
};

struct FNiagaraPosition : FVector3f {
    using FVector3f::FVector3f;
    explicit FNiagaraPosition(const FVector3f& V) : FVector3f(V) {}
};

struct FNiagaraLWCConverter {
    explicit FNiagaraLWCConverter(FVector InSystemWorldPos = FVector::ZeroVector) : SystemWorldPos(InSystemWorldPos) {}
    FNiagaraPosition ConvertWorldToSimulationPosition(FVector WorldPosition) const {
        return FNiagaraPosition(FVector3f(WorldPosition - SystemWorldPos));
    }

protected:
    FVector SystemWorldPos;
};

class FNiagaraSystemInstance {
public:
    USceneComponent* GetAttachComponent() { return ShimAttach; }
    FNiagaraLWCConverter GetLWCConverter(bool = false) const { return FNiagaraLWCConverter(ShimTile); }
    USceneComponent* ShimAttach = nullptr;
    FVector ShimTile;
};

class UNiagaraDataInterface : public UObject {
    SHIM_OBJECT(UNiagaraDataInterface, UObject)
public:
    virtual void GetVMExternalFunction(const FVMExternalFunctionBindingInfo&, void*, FVMExternalFunction&) {}
    virtual bool CanExecuteOnTarget(ENiagaraSimTarget) const { return false; }
    virtual int32 PerInstanceDataSize() const { return 0; }
    virtual bool InitPerInstanceData(void*, FNiagaraSystemInstance*) { return true; }
    virtual void DestroyPerInstanceData(void*, FNiagaraSystemInstance*) {}
    virtual bool HasPreSimulateTick() const { return false; }
    virtual bool PerInstanceTick(void*, FNiagaraSystemInstance*, float) { return false; }
    virtual bool Equals(const UNiagaraDataInterface* Other) const {
        return Other != nullptr && Other->GetClass() == GetClass();
    }
    bool CopyTo(UNiagaraDataInterface* Destination) const { return CopyToInternal(Destination); }
    void GetFunctionSignatures(TArray<FNiagaraFunctionSignature>& OutFunctions) const {
        GetFunctionsInternal(OutFunctions);
    }

protected:
    virtual void GetFunctionsInternal(TArray<FNiagaraFunctionSignature>&) const {}
    virtual bool CopyToInternal(UNiagaraDataInterface* Destination) const {
        return Destination != nullptr && Destination->GetClass() == GetClass();
    }
};
