// The shim's Core: log, memory, files, libraries, tasks. SPDX-License-Identifier: MIT
#include "shim.h"

#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <deque>
#include <dlfcn.h>
#include <fstream>
#include <map>
#include <mutex>
#include <sys/wait.h>
#include <thread>

std::u16string ShimWiden(const std::string& Text) {
    std::u16string Out;
    for (std::size_t i = 0; i < Text.size();) {
        const auto Byte = static_cast<unsigned char>(Text[i++]);
        char32_t Code = Byte < 0x80 ? Byte : Byte < 0xe0 ? Byte & 0x1fu : Byte < 0xf0 ? Byte & 0xfu : Byte & 7u;
        for (int Left = Byte < 0xc0 ? 0 : Byte < 0xe0 ? 1 : Byte < 0xf0 ? 2 : 3; Left > 0 && i < Text.size(); --Left) {
            Code = Code << 6 | (static_cast<unsigned char>(Text[i++]) & 0x3fu);
        }
        if (Code >= 0x10000) {
            Out += static_cast<char16_t>(0xd7c0 + (Code >> 10));
            Code = 0xdc00 + (Code & 0x3ff);
        }
        Out += static_cast<char16_t>(Code);
    }
    return Out;
}

std::string ShimNarrow(const std::u16string& Text) {
    std::string Out;
    for (const char16_t C : Text) {
        if (C < 0x80) {
            Out += static_cast<char>(C);
        } else if (C < 0x800) {
            Out += static_cast<char>(0xc0 | C >> 6);
            Out += static_cast<char>(0x80 | (C & 0x3f));
        } else {
            Out += static_cast<char>(0xe0 | C >> 12);
            Out += static_cast<char>(0x80 | (C >> 6 & 0x3f));
            Out += static_cast<char>(0x80 | (C & 0x3f));
        }
    }
    return Out;
}

bool FString::Equals(const FString& Other, ESearchCase::Type Case) const {
    const auto Fold = [Case](char16_t C) {
        return Case == ESearchCase::IgnoreCase && C >= u'A' && C <= u'Z' ? static_cast<char16_t>(C + 32) : C;
    };
    return std::equal(Data.begin(), Data.end(), Other.Data.begin(), Other.Data.end(),
                      [&](char16_t A, char16_t B) { return Fold(A) == Fold(B); });
}

FString FString::Format(const TCHAR* Fmt, std::initializer_list<FArgument> Arguments) {
    std::u16string Out;
    const FArgument* Next = Arguments.begin();
    const auto Refuse = [&] {
        std::fprintf(stderr, "FString::Printf: a conversion does not fit its argument: %s\n", ShimNarrow(Fmt).c_str());
        std::abort();
    };
    for (; *Fmt != 0; ++Fmt) {
        if (*Fmt != u'%') {
            Out += *Fmt;
            continue;
        }
        std::string Spec = "%";
        for (++Fmt; *Fmt != 0 && std::strchr("0123456789.+-# l", static_cast<char>(*Fmt)); ++Fmt) {
            if (*Fmt != u'l') Spec += static_cast<char>(*Fmt);
        }
        if (*Fmt == u'%') {
            Out += u'%';
            continue;
        }
        if (Next == Arguments.end()) Refuse();
        const FArgument& Argument = *Next++;
        char Buffer[64] = "";
        switch (*Fmt) {
        case u's':
            if (Argument.Kind != 's') Refuse();
            Out += Argument.Pointer;
            break;
        case u'd':
        case u'i':
        case u'u':
        case u'x':
            if (Argument.Kind != (*Fmt == u'd' || *Fmt == u'i' ? 'd' : 'u')) Refuse();
            Spec += std::string("ll") + static_cast<char>(*Fmt);
            std::snprintf(Buffer, sizeof(Buffer), Spec.c_str(), static_cast<long long>(Argument.Integer));
            break;
        case u'f':
        case u'g':
            if (Argument.Kind != 'f') Refuse();
            Spec += static_cast<char>(*Fmt);
            std::snprintf(Buffer, sizeof(Buffer), Spec.c_str(), Argument.Real);
            break;
        default:
            Refuse();
        }
        Out += ShimWiden(Buffer);
    }
    if (Next != Arguments.end()) Refuse();
    return FString(Out);
}

namespace {
std::mutex LogMutex;
std::vector<std::string> LogLines;
std::atomic<int64> Allocations{0};
} // namespace

void ShimLog(const char* Category, ELogVerbosity::Type Verbosity, const FString& Line) {
    static const char* const Names[] = {"",    "Fatal",   "Error",       "Warning", "Display",
                                        "Log", "Verbose", "VeryVerbose", ""};
    const std::lock_guard Lock(LogMutex);
    LogLines.push_back(std::string(Category) + ": " + Names[Verbosity] + ": " + ShimNarrow(*Line));
    if (std::getenv("SHIM_LOG") != nullptr) std::fprintf(stderr, "%s\n", LogLines.back().c_str());
}

std::vector<std::string> ShimTakeLog() {
    const std::lock_guard Lock(LogMutex);
    return std::exchange(LogLines, {});
}

void* FMemory::Malloc(SIZE_T Count, uint32 Alignment) {
    ++Allocations;
    const SIZE_T Aligned = std::max<SIZE_T>(Alignment, 16);
    return std::aligned_alloc(Aligned, (Count + Aligned - 1) / Aligned * Aligned);
}

void FMemory::Free(void* Original) {
    if (Original != nullptr) --Allocations;
    std::free(Original);
}

int64 ShimLiveAllocations() {
    return Allocations;
}

void* FPlatformProcess::GetDllHandle(const TCHAR* Filename) {
    return dlopen(ShimNarrow(Filename).c_str(), RTLD_NOW);
}
void FPlatformProcess::FreeDllHandle(void* DllHandle) {
    dlclose(DllHandle);
}
void FPlatformProcess::PushDllDirectory(const TCHAR*) {}
void FPlatformProcess::PopDllDirectory(const TCHAR*) {}

FString FPaths::GetPath(const FString& Path) {
    const std::u16string Text = *Path;
    const std::size_t Slash = Text.rfind(u'/');
    return FString(Slash == std::u16string::npos ? u"" : Text.substr(0, Slash));
}

FString FPaths::GetExtension(const FString& Path) {
    const std::u16string Text = *Path;
    const std::size_t Dot = Text.rfind(u'.');
    return FString(Dot == std::u16string::npos ? u"" : Text.substr(Dot + 1));
}

bool FPaths::FileExists(const FString& Path) {
    return std::ifstream(ShimNarrow(*Path)).good();
}

FString FPaths::ProjectIntermediateDir() {
    const char* const Folder = std::getenv("LANGEVIN_TEST_RECORDINGS");
    return FString(ShimWiden(Folder != nullptr ? Folder : "/tmp"));
}

FString FPaths::CreateTempFilename(const TCHAR* Path, const TCHAR* Prefix, const TCHAR* Extension) {
    static int Count = 0;
    return Combine(Path, FString::Printf(TEXT("%s%d%s"), Prefix, ++Count, Extension));
}

bool FFileHelper::SaveStringToFile(const FString& String, const TCHAR* Filename, EEncodingOptions) {
    std::ofstream File(ShimNarrow(Filename), std::ios::binary);
    File << ShimNarrow(*String);
    return File.good();
}

bool IFileManager::Delete(const TCHAR* Filename, bool, bool, bool) {
    return std::remove(ShimNarrow(Filename).c_str()) == 0;
}

bool FPlatformProcess::ExecProcess(const TCHAR* URL, const TCHAR* Params, int32* OutReturnCode, FString* OutStdOut,
                                   FString* OutStdErr, const TCHAR*, bool) {
    const std::string Errors =
        ShimNarrow(*FPaths::CreateTempFilename(*FPaths::ProjectIntermediateDir(), TEXT("stderr")));
    FILE* const Pipe = popen(("'" + ShimNarrow(URL) + "' " + ShimNarrow(Params) + " 2>'" + Errors + "'").c_str(), "r");
    if (Pipe == nullptr) return false;
    std::string Text;
    for (int C; (C = std::fgetc(Pipe)) != EOF;) Text += static_cast<char>(C);
    const int Status = pclose(Pipe);
    *OutReturnCode = WIFEXITED(Status) ? WEXITSTATUS(Status) : -1;
    *OutStdOut = FString(ShimWiden(Text));
    std::ifstream File(Errors);
    *OutStdErr = FString(ShimWiden(std::string{std::istreambuf_iterator<char>(File), {}}));
    std::remove(Errors.c_str());
    return true;
}

bool FFileHelper::LoadFileToArray(TArray<uint8>& Result, const TCHAR* Filename, uint32) {
    std::ifstream File(ShimNarrow(Filename), std::ios::binary);
    if (!File) return false;
    const std::vector<char> Bytes{std::istreambuf_iterator<char>(File), {}};
    Result.Reset();
    Result.Append(reinterpret_cast<const uint8*>(Bytes.data()), static_cast<int32>(Bytes.size()));
    return true;
}

namespace {

class FShimFileWriter final : public FArchive {
public:
    explicit FShimFileWriter(std::FILE* InFile) : File(InFile) {}
    virtual ~FShimFileWriter() override { Close(); }
    virtual void Serialize(void* V, int64 Length) override {
        const auto Size = static_cast<std::size_t>(Length);
        bError = bError || std::fwrite(V, 1, Size, File) != Size;
    }
    virtual void Flush() override { bError = std::fflush(File) != 0 || bError; }
    virtual bool Close() override {
        if (File) bError = std::fclose(File) != 0 || bError;
        File = nullptr;
        return !bError;
    }

private:
    std::FILE* File;
};

} // namespace

IFileManager& IFileManager::Get() {
    static IFileManager Manager;
    return Manager;
}

FArchive* IFileManager::CreateFileWriter(const TCHAR* Filename, uint32) {
    std::FILE* const File = std::fopen(ShimNarrow(Filename).c_str(), "wb");
    return File ? new FShimFileWriter(File) : nullptr;
}

IPluginManager& IPluginManager::Get() {
    static IPluginManager Manager;
    return Manager;
}

TSharedPtr<IPlugin> IPluginManager::FindPlugin(const FString& Name) {
    if (ShimBaseDir.IsEmpty() || !(Name == FString(TEXT("LangevinRigid")))) return nullptr;
    return TSharedPtr<IPlugin>(std::make_shared<IPlugin>(ShimBaseDir));
}

// ---------------------------------------------------------------------------------------------------------------------
// Tasks: some threads with a queue; a thread that waits for a task that has not started runs it.

namespace UE::Tasks {
struct FShimTask {
    std::function<void()> Body;
    std::thread::id Launcher;
    std::atomic<bool> bTaken{false}, bDone{false};
};
} // namespace UE::Tasks

namespace {
using UE::Tasks::FShimTask;
std::atomic<uint64> Elsewhere{0};

void Run(FShimTask& Task) {
    if (Task.bTaken.exchange(true)) return;
    if (std::this_thread::get_id() != Task.Launcher) ++Elsewhere;
    Task.Body();
    Task.bDone = true;
    Task.bDone.notify_all();
}

struct FPool {
    std::mutex Mutex;
    std::condition_variable Changed;
    std::deque<std::shared_ptr<FShimTask>> Queue;
    bool bStopping = false;
    std::vector<std::thread> Threads;

    FPool() {
        for (int i = 0; i < 3; ++i) Threads.emplace_back([this] { Work(); });
    }
    ~FPool() {
        {
            const std::lock_guard Lock(Mutex);
            bStopping = true;
        }
        Changed.notify_all();
        for (std::thread& Thread : Threads) Thread.join();
    }
    void Work() {
        for (;;) {
            std::unique_lock Lock(Mutex);
            Changed.wait(Lock, [this] { return bStopping || !Queue.empty(); });
            if (Queue.empty()) return;
            const std::shared_ptr<FShimTask> Task = Queue.front();
            Queue.pop_front();
            Lock.unlock();
            Run(*Task);
        }
    }
};

FPool& Pool() {
    static FPool Instance;
    return Instance;
}
} // namespace

uint64 ShimTasksElsewhere() {
    return Elsewhere;
}

FTaskGraphInterface& FTaskGraphInterface::Get() {
    static FTaskGraphInterface Instance;
    return Instance;
}

int32 FTaskGraphInterface::GetNumWorkerThreads() const {
    return static_cast<int32>(Pool().Threads.size());
}

UE::Tasks::FTask UE::Tasks::ShimLaunch(std::function<void()> Body) {
    FTask Task{std::make_shared<FShimTask>()};
    Task.Pimpl->Body = std::move(Body);
    Task.Pimpl->Launcher = std::this_thread::get_id();
    {
        const std::lock_guard Lock(Pool().Mutex);
        Pool().Queue.push_back(Task.Pimpl);
    }
    Pool().Changed.notify_one();
    return Task;
}

void UE::Tasks::ShimWait(const FTask& Task) {
    Run(*Task.Pimpl);
    Task.Pimpl->bDone.wait(false);
}

void ParallelFor(int32 Num, TFunctionRef<void(int32)> Body, EParallelForFlags Flags) {
    TArray<UE::Tasks::FTask> Tasks;
    const bool bAlone = Flags == EParallelForFlags::ForceSingleThread;
    for (int32 Index = 1; Index < Num && !bAlone; ++Index)
        Tasks.Add(UE::Tasks::ShimLaunch([Body, Index] { Body(Index); }));
    for (int32 Index = 0; Index < (bAlone ? Num : FMath::Min(Num, 1)); ++Index) Body(Index);
    UE::Tasks::Wait(Tasks);
}

// ---------------------------------------------------------------------------------------------------------------------
// Modules

namespace {
struct FModule {
    IModuleInterface* (*Make)() = nullptr;
    IModuleInterface* Running = nullptr;
};
std::map<std::string, FModule>& Modules() {
    static std::map<std::string, FModule> All;
    return All;
}
} // namespace

void ShimRegisterModule(const char* Name, IModuleInterface* (*Make)()) {
    Modules()[Name] = {Make, nullptr};
}

IModuleInterface* ShimStartModule(const char* Name) {
    FModule& Module = Modules().at(Name);
    Module.Running = Module.Make();
    Module.Running->StartupModule();
    return Module.Running;
}

void ShimStopModule(const char* Name) {
    FModule& Module = Modules().at(Name);
    Module.Running->ShutdownModule();
    delete std::exchange(Module.Running, nullptr);
}
