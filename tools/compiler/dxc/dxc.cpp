// A `dxc` command for the DXC library that comes without one. It takes dxc's own arguments, of
// which it handles itself only those that a library cannot: --version, -Fo, -P, the input file.
// The library is loaded from the path in BROOKLET_DXC_LIBRARY.
//
// Kept apart from Rust because the IUnknown of DXC on Linux changed its vtable between versions:
// compiled against the library's own header it is always the right one.
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "dxcapi.h"

static std::wstring widen(const std::string &text)
{
    return std::wstring(text.begin(), text.end());
}

static int fail(const std::string &what)
{
    std::cerr << "dxc: " << what << "\n";
    return 3;
}

template <typename T> static T *blob_of(IDxcResult *result, DXC_OUT_KIND kind)
{
    T *blob = nullptr;
    if (!result->HasOutput(kind) || FAILED(result->GetOutput(kind, __uuidof(T), (void **)&blob, nullptr)))
        return nullptr;
    return blob;
}

static int print_version(IDxcCompiler3 *compiler)
{
    IDxcVersionInfo *info = nullptr;
    UINT32 major = 0, minor = 0, count = 0;
    if (FAILED(compiler->QueryInterface(__uuidof(IDxcVersionInfo), (void **)&info)) || FAILED(info->GetVersion(&major, &minor)))
        return fail("the library tells no version");
    std::cout << "dxc " << major << "." << minor;
    IDxcVersionInfo2 *commit = nullptr;
    char *hash = nullptr;
    if (SUCCEEDED(compiler->QueryInterface(__uuidof(IDxcVersionInfo2), (void **)&commit)) && SUCCEEDED(commit->GetCommitInfo(&count, &hash)))
        std::cout << " " << count << " " << hash;
    std::cout << "\n";
    return 0;
}

int main(int argc, char **argv)
{
    const char *library_path = std::getenv("BROOKLET_DXC_LIBRARY");
    if (!library_path)
        return fail("BROOKLET_DXC_LIBRARY is not set");
    void *library = dlopen(library_path, RTLD_NOW);
    if (!library)
        return fail(dlerror());
    auto create = (DxcCreateInstanceProc)dlsym(library, "DxcCreateInstance");
    IDxcUtils *utils = nullptr;
    IDxcCompiler3 *compiler = nullptr;
    if (!create || FAILED(create(CLSID_DxcUtils, __uuidof(IDxcUtils), (void **)&utils)) || FAILED(create(CLSID_DxcCompiler, __uuidof(IDxcCompiler3), (void **)&compiler)))
        return fail(std::string("no compiler in ") + library_path);

    std::vector<std::wstring> arguments;
    std::string output_path, input_path;
    bool preprocess = false;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument == "--version")
            return print_version(compiler);
        if (argument == "-P")
            preprocess = true;
        if (argument == "-Fo" && i + 1 < argc)
            output_path = argv[++i];
        else if ((argument == "-T" || argument == "-E" || argument == "-D" || argument == "-I") && i + 1 < argc) {
            arguments.push_back(widen(argument));
            arguments.push_back(widen(argv[++i]));
        } else if (argument[0] != '-')
            input_path = argument;
        else
            arguments.push_back(widen(argument));
    }
    std::ifstream input(input_path, std::ios::binary);
    if (!input)
        return fail("cannot read " + input_path);
    const std::string text((std::istreambuf_iterator<char>(input)), std::istreambuf_iterator<char>());
    arguments.insert(arguments.begin(), widen(input_path));

    std::vector<LPCWSTR> pointers;
    for (const auto &argument : arguments)
        pointers.push_back(argument.c_str());
    IDxcIncludeHandler *includes = nullptr;
    utils->CreateDefaultIncludeHandler(&includes);
    DxcBuffer source{text.data(), text.size(), DXC_CP_UTF8};
    IDxcResult *result = nullptr;
    if (FAILED(compiler->Compile(&source, pointers.data(), (UINT32)pointers.size(), includes, __uuidof(IDxcResult), (void **)&result)))
        return fail("the library refused to compile");

    if (auto *errors = blob_of<IDxcBlobUtf8>(result, DXC_OUT_ERRORS))
        std::cerr.write(errors->GetStringPointer(), errors->GetStringLength());
    HRESULT status = E_FAIL;
    if (FAILED(result->GetStatus(&status)) || FAILED(status))
        return 1;
    IDxcBlob *object = blob_of<IDxcBlob>(result, preprocess ? DXC_OUT_HLSL : DXC_OUT_OBJECT);
    if (!object)
        return fail("no output");
    if (output_path.empty()) {
        std::cout.write((const char *)object->GetBufferPointer(), object->GetBufferSize());
        return 0;
    }
    std::ofstream output(output_path, std::ios::binary);
    output.write((const char *)object->GetBufferPointer(), object->GetBufferSize());
    output.flush();
    return output ? 0 : fail("cannot write " + output_path);
}
