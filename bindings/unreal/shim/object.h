// Objects, classes, pointers to objects, modules, tasks. GENERATED_BODY is filled in by header_tool.py, as the engine's header tool
// does. SPDX-License-Identifier: MIT
#pragma once

#include "core.h"
#include "math.h"

#define UCLASS(...)
#define USTRUCT(...)
#define UENUM(...)
#define UPROPERTY(...)
#define UFUNCTION(...)
#define SHIM_COMBINE_INNER(A, B, C, D) A##B##C##D
#define SHIM_COMBINE(A, B, C, D) SHIM_COMBINE_INNER(A, B, C, D)
#define GENERATED_BODY() SHIM_COMBINE(CURRENT_FILE_ID, _, __LINE__, _GENERATED_BODY)

class UObject;
class UWorld;

enum EObjectFlags : uint32 { RF_NoFlags = 0, RF_Public = 1, RF_Standalone = 2, RF_ClassDefaultObject = 0x10 };

class FObjectInitializer {};
class FVTableHelper {};

class UClass {
public:
    FName Name;
    UClass* Parent;
    UObject* (*Construct)();
    UObject* Default = nullptr;
    UObject* GetDefaultObject();
    bool IsChildOf(const UClass* Other) const {
        for (const UClass* Class = this; Class != nullptr; Class = Class->Parent) {
            if (Class == Other) return true;
        }
        return false;
    }
};

class UObject {
public:
    UObject();
    UObject(const FObjectInitializer&) : UObject() {}
    UObject(FVTableHelper&) {}
    virtual ~UObject() = default;
    static UClass* StaticClass();
    virtual UClass* GetClass() const { return StaticClass(); }
    virtual void PostInitProperties() {}
    virtual void PostLoad() {}
    virtual void BeginDestroy() {}
    virtual UWorld* GetWorld() const { return ShimOuter != nullptr ? ShimOuter->GetWorld() : nullptr; }
    UObject* GetOuter() const { return ShimOuter; }
    FString GetName() const;
    class UPackage* GetOutermost() const;
    FString GetPathName() const { return ShimName.ToString(); }
    bool HasAnyFlags(EObjectFlags Any) const { return (ShimFlags & Any) != 0; }
    void MarkAsGarbage() { bGarbage = true; }
    bool MarkPackageDirty() const { return ++DirtyCount > 0; }

    UObject* ShimOuter = nullptr;
    FName ShimName;
    uint32 ShimFlags = RF_NoFlags;
    bool bGarbage = false;
    mutable int32 DirtyCount = 0;
};

template <typename T> UObject* ShimConstruct() {
    if constexpr (std::is_constructible_v<T, const FObjectInitializer&>) {
        return new T(FObjectInitializer());
    } else {
        return new T();
    }
}
#define SHIM_OBJECT(Type, Base)                                                                                        \
public:                                                                                                                \
    using ThisClass = Type;                                                                                            \
    using Super = Base;                                                                                                \
    static UClass* StaticClass() {                                                                                     \
        static UClass Class{FName(TEXT(#Type)), Base::StaticClass(), &ShimConstruct<Type>};                            \
        return &Class;                                                                                                 \
    }                                                                                                                  \
    virtual UClass* GetClass() const override {                                                                        \
        return StaticClass();                                                                                          \
    }

/** All live objects; this shim collects garbage at the end of the program. */
const std::vector<UObject*>& ShimObjects();
void ShimDestroy(UObject* Object);
UObject* ShimNewObject(UObject* Outer, const UClass* Class, FName Name, uint32 Flags);

template <typename T>
T* NewObject(UObject* Outer, const UClass* Class, FName Name = NAME_None, EObjectFlags Flags = RF_NoFlags) {
    return static_cast<T*>(ShimNewObject(Outer, Class, Name, Flags));
}
template <typename T> T* NewObject(UObject* Outer, FName Name, EObjectFlags Flags = RF_NoFlags) {
    return NewObject<T>(Outer, T::StaticClass(), Name, Flags);
}
template <typename T> T* NewObject(UObject* Outer) {
    return NewObject<T>(Outer, T::StaticClass());
}
template <typename T> T* GetMutableDefault() {
    return static_cast<T*>(T::StaticClass()->GetDefaultObject());
}
template <typename T> const T* GetDefault() {
    return GetMutableDefault<T>();
}

template <typename T, typename U> T* Cast(U* Object) {
    if constexpr (std::is_const_v<U>) {
        return const_cast<T*>(dynamic_cast<const T*>(Object));
    } else {
        return dynamic_cast<T*>(Object);
    }
}
template <typename T, typename U>
requires std::is_const_v<U>
const T* Cast(U* Object) {
    return dynamic_cast<const T*>(Object);
}
template <typename T, typename U> auto CastChecked(U* Object) {
    auto* Result = Cast<T>(Object);
    if (Result == nullptr) std::abort();
    return Result;
}

template <typename T> class TObjectPtr {
public:
    TObjectPtr(T* From = nullptr) : Data(From) {}
    operator T*() const { return Data; }
    T* Get() const { return Data; }
    T* operator->() const { return Data; }

private:
    T* Data;
};

template <typename T> class TWeakObjectPtr {
public:
    TWeakObjectPtr(T* From = nullptr) : Data(From) {}
    T* Get() const { return IsValid() ? Data : nullptr; }
    bool IsValid() const { return Data != nullptr && !static_cast<const UObject*>(Data)->bGarbage; }
    TWeakObjectPtr& operator=(T* From) { return Data = From, *this; }

private:
    T* Data;
};

template <typename T> class TSoftObjectPtr {
public:
    TSoftObjectPtr(T* From = nullptr) : Data(From) {}
    T* Get() const { return Data; }
    bool operator==(const TSoftObjectPtr& Other) const { return Data == Other.Data; }

private:
    T* Data;
};

template <typename T> class TSubclassOf {
public:
    TSubclassOf& operator=(UClass* From) { return Class = From, *this; }
    UClass* Get() const { return Class; }

private:
    UClass* Class = nullptr;
};

template <typename T> class TSoftClassPtr {
public:
    TSoftClassPtr(const UClass* From) : Class(From) {}
    const UClass* Get() const { return Class; }

private:
    const UClass* Class;
};

template <typename T> class TObjectIterator {
public:
    TObjectIterator() { Settle(); }
    explicit operator bool() const { return Index < ShimObjects().size(); }
    TObjectIterator& operator++() { return ++Index, Settle(), *this; }
    T* operator*() const { return Cast<T>(ShimObjects()[Index]); }
    T* operator->() const { return **this; }

private:
    void Settle() {
        while (*this && (**this == nullptr || ShimObjects()[Index]->bGarbage)) ++Index;
    }
    std::size_t Index = 0;
};

class IModuleInterface {
public:
    virtual ~IModuleInterface() = default;
    virtual void StartupModule() {}
    virtual void ShutdownModule() {}
};
class FDefaultModuleImpl : public IModuleInterface {};
void ShimRegisterModule(const char* Name, IModuleInterface* (*Make)());
/** Starts or shuts down a module, like the module manager. */
IModuleInterface* ShimStartModule(const char* Name);
void ShimStopModule(const char* Name);
#define IMPLEMENT_MODULE(Class, Module)                                                                                \
    static const bool bShimRegistered##Module = [] {                                                                   \
        ShimRegisterModule(#Module, []() -> IModuleInterface* { return new Class; });                                  \
        return true;                                                                                                   \
    }();

struct FPlatformProcess {
    static void* GetDllHandle(const TCHAR* Filename);
    static void FreeDllHandle(void* DllHandle);
    static void PushDllDirectory(const TCHAR* Directory);
    static void PopDllDirectory(const TCHAR* Directory);
    static const TCHAR* GetBinariesSubdirectory() { return TEXT("Linux"); }
    static bool ExecProcess(const TCHAR* URL, const TCHAR* Params, int32* OutReturnCode, FString* OutStdOut,
                            FString* OutStdErr, const TCHAR* OptionalWorkingDirectory = nullptr,
                            bool bShouldEndWithParentProcess = false);
};

struct FPaths {
    template <typename... T> static FString Combine(const T&... Parts) {
        std::u16string Out;
        const auto Add = [&Out](const FString& Part) {
            if (!Out.empty()) Out += u'/';
            Out += *Part;
        };
        (Add(FString(Parts)), ...);
        return FString(Out);
    }
    static FString GetPath(const FString& Path);
    static FString GetExtension(const FString& Path);
    static bool FileExists(const FString& Path);
    static FString ProjectIntermediateDir();
    static FString ConvertRelativePathToFull(const FString& Path) { return Path; }
    static FString CreateTempFilename(const TCHAR* Path, const TCHAR* Prefix = TEXT(""),
                                      const TCHAR* Extension = TEXT(".tmp"));
};

class IPlugin {
public:
    explicit IPlugin(FString InBaseDir) : BaseDir(std::move(InBaseDir)) {}
    const FString& GetBaseDir() const { return BaseDir; }

private:
    FString BaseDir;
};
class IPluginManager {
public:
    static IPluginManager& Get();
    TSharedPtr<IPlugin> FindPlugin(const FString& Name);
    FString ShimBaseDir; // the folder of LangevinRigid; empty: not found
};

class FTaskGraphInterface {
public:
    static FTaskGraphInterface& Get();
    int32 GetNumWorkerThreads() const;
};

namespace UE::Tasks {
enum class ETaskPriority : int8 { High, Normal, BackgroundHigh, BackgroundNormal, BackgroundLow };
struct FShimTask;
template <typename ResultType> class TTask {
public:
    std::shared_ptr<FShimTask> Pimpl;
};
using FTask = TTask<void>;
FTask ShimLaunch(std::function<void()> Body);
void ShimWait(const FTask& Task);
template <typename TaskBodyType>
FTask Launch(const TCHAR*, TaskBodyType&& TaskBody, ETaskPriority = ETaskPriority::Normal) {
    return ShimLaunch(std::forward<TaskBodyType>(TaskBody));
}
template <typename TaskCollectionType> bool Wait(const TaskCollectionType& Tasks) {
    for (const auto& Task : Tasks) ShimWait(Task);
    return true;
}
} // namespace UE::Tasks
/** Number of tasks that ran on another thread than that of their launch. */
uint64 ShimTasksElsewhere();
#define UE_SOURCE_LOCATION TEXT(__FILE__)

enum class EParallelForFlags { None = 0, ForceSingleThread = 1 };
void ParallelFor(int32 Num, TFunctionRef<void(int32)> Body, EParallelForFlags Flags = EParallelForFlags::None);

class FFeedbackContext {
public:
    template <typename FmtType, typename... Types>
    void Logf(ELogVerbosity::Type Verbosity, const FmtType& Fmt, Types... Args) {
        ShimLog("FeedbackContext", Verbosity, FString::Printf(Fmt, Args...));
    }
};

struct FFileHelper {
    static bool LoadFileToArray(TArray<uint8>& Result, const TCHAR* Filename, uint32 Flags = 0);
    enum class EEncodingOptions { AutoDetect, ForceUTF8WithoutBOM };
    static bool SaveStringToFile(const FString& String, const TCHAR* Filename,
                                 EEncodingOptions Options = EEncodingOptions::AutoDetect);
};

class FArchive {
public:
    virtual ~FArchive() = default;
    virtual void Serialize(void* V, int64 Length) = 0;
    virtual void Flush() = 0;
    virtual bool Close() = 0;
    bool IsError() const { return bError; }

protected:
    bool bError = false;
};
enum EFileWrite { FILEWRITE_None = 0x00, FILEWRITE_AllowRead = 0x10 };
class IFileManager {
public:
    static IFileManager& Get();
    FArchive* CreateFileWriter(const TCHAR* Filename, uint32 WriteFlags = 0);
    bool Delete(const TCHAR* Filename, bool RequireExists = false, bool EvenReadOnly = false, bool Quiet = false);
};

class UPackage : public UObject {
    SHIM_OBJECT(UPackage, UObject)
};
struct FPackageName {
    static FString GetLongPackagePath(const FString& InLongPackageName) { return FPaths::GetPath(InLongPackageName); }
};
inline bool UObjectInitialized() {
    return true;
}
enum ELoadFlags : uint32 { LOAD_None = 0, LOAD_NoWarn = 2, LOAD_Quiet = 0x2000 };
UObject* ShimFind(const TCHAR* Name, const UClass* Class);
template <class T>
T* LoadObject(UObject*, const TCHAR* Name, const TCHAR* Filename = nullptr, uint32 LoadFlags = LOAD_None) {
    static_cast<void>(Filename);
    static_cast<void>(LoadFlags);
    return static_cast<T*>(ShimFind(Name, T::StaticClass()));
}
