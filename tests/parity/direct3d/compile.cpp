// SPDX-License-Identifier: MIT
//
// Microsoft's two HLSL compilers over pixel shaders, for Windows or Wine:
//
//     compile [FOLDER/d3dcompiler_47.dll | FOLDER/dxcompiler.dll] FILE...
//
// Each file's code goes to FILE.dxbc or FILE.dxil. Exit status: 0 all are accepted, 1 not all, 2 no compiler.
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include <windows.h>
#include <d3dcompiler.h>

namespace {

struct outcome {
    HRESULT status = E_FAIL;
    std::string words, code;
};

std::string text_of(ID3DBlob* blob) {
    return blob ? std::string(static_cast<const char*>(blob->GetBufferPointer()), blob->GetBufferSize()) : "";
}

outcome compile_fxc(HMODULE library, const std::string& source) {
    const auto compile = reinterpret_cast<pD3DCompile>(reinterpret_cast<void*>(GetProcAddress(library, "D3DCompile")));
    ID3DBlob *code = nullptr, *words = nullptr;
    outcome o;
    o.status = compile(source.data(), source.size(), "shader", nullptr, nullptr, "main", "ps_5_0", 0, 0, &code, &words);
    o.words = text_of(words);
    o.code = text_of(code);
    return o;
}

// The part of DXC's interface that is needed; blobs are those of Direct3D.
struct dxc_buffer {
    const void* data;
    SIZE_T size;
    UINT encoding;
};
struct dxc_result : IUnknown {
    virtual HRESULT STDMETHODCALLTYPE GetStatus(HRESULT*) = 0;
    virtual HRESULT STDMETHODCALLTYPE GetResult(ID3DBlob**) = 0;
    virtual HRESULT STDMETHODCALLTYPE GetErrorBuffer(ID3DBlob**) = 0;
};
struct dxc_compiler : IUnknown {
    virtual HRESULT STDMETHODCALLTYPE Compile(const dxc_buffer*, LPCWSTR*, UINT32, IUnknown*, REFIID, void**) = 0;
};
constexpr GUID compiler_class{0x73e22d93, 0xe6ce, 0x47f3, {0xb5, 0xbf, 0xf0, 0x66, 0x4f, 0x39, 0xc1, 0xb0}};
constexpr GUID compiler_interface{0x228b4687, 0x5a6a, 0x4730, {0x90, 0x0c, 0x97, 0x02, 0xb2, 0x20, 0x3f, 0x54}};
constexpr GUID result_interface{0xcedb484a, 0xd4e9, 0x445a, {0xb9, 0x91, 0xca, 0x21, 0xca, 0x15, 0x7d, 0xc2}};

outcome compile_dxc(HMODULE library, const std::string& source) {
    using create = HRESULT(WINAPI*)(REFIID, REFIID, void**);
    const auto make = reinterpret_cast<create>(reinterpret_cast<void*>(GetProcAddress(library, "DxcCreateInstance")));
    static dxc_compiler* compiler = nullptr;
    outcome o;
    if (!compiler && FAILED(make(compiler_class, compiler_interface, reinterpret_cast<void**>(&compiler)))) return o;
    const dxc_buffer buffer{source.data(), source.size(), 65001};  // UTF-8
    LPCWSTR arguments[]{L"-E", L"main", L"-T", L"ps_6_0"};
    dxc_result* result = nullptr;
    if (FAILED(compiler->Compile(&buffer, arguments, 4, nullptr, result_interface, reinterpret_cast<void**>(&result))))
        return o;
    ID3DBlob *code = nullptr, *words = nullptr;
    result->GetStatus(&o.status);
    result->GetErrorBuffer(&words);
    result->GetResult(&code);
    o.words = text_of(words);
    o.code = text_of(code);
    return o;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string path = argc > 1 ? argv[1] : "";
    const HMODULE library = LoadLibraryA(path.c_str());
    if (!library) {
        std::printf("cannot load %s\n", path.c_str());
        return 2;
    }
    const bool dxc = path.find("dxcompiler") != path.npos;
    int refused = 0;
    for (int i = 2; i < argc; ++i) {
        std::ifstream file(argv[i], std::ios::binary);
        const std::string source(std::istreambuf_iterator<char>(file), {});
        const outcome o = dxc ? compile_dxc(library, source) : compile_fxc(library, source);
        if (!o.words.empty()) std::printf("%s: %s\n", argv[i], o.words.c_str());
        if (FAILED(o.status)) {
            ++refused;
            std::printf("REFUSED: %s\n", argv[i]);
        }
        std::ofstream(argv[i] + std::string(dxc ? ".dxil" : ".dxbc"), std::ios::binary) << o.code;
    }
    std::printf("%d shaders, %d refused\n", argc - 2, refused);
    return refused ? 1 : 0;
}
