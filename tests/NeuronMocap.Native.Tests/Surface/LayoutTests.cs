using System.Runtime.InteropServices;
using NeuronMocap.Native.Tests.Infrastructure;

namespace NeuronMocap.Native.Tests.Surface;

// Compiles the headers with every installed compiler. tests/native/layout.h asserts all sizes, offsets and values, and there are no warnings.
public sealed class LayoutTests
{
    private static readonly string[] Names = ["gcc", "g++", "clang", "clang++"];

    private static readonly string[] Strict =
    [
        "-fsyntax-only", "-pedantic", "-Wall", "-Wextra", "-Wpadded", "-Wshadow", "-Wconversion", "-Wwrite-strings", "-Werror",
        "-I" + NativeFiles.Headers,
    ];

    // As on 32-bit Windows, where callbacks and functions have different calling conventions.
    private static readonly string[] Windows =
    [
        "-m32", "-ffreestanding", "-D_WIN32", "-D__declspec(x)=", "-D__stdcall=__attribute__((stdcall))", "-D__cdecl=__attribute__((cdecl))",
    ];

    /// <summary>A row for each installed compiler, standard and generation, or one skipped row if there is no compiler.</summary>
    public static IEnumerable<TheoryDataRow<string, string, string>> Compilers =>
        Names.Any(InstalledPrograms.Have) ? Names.Where(InstalledPrograms.Have).SelectMany(Rows) : [new(Names[0], "", "") { Skip = "Neither gcc nor clang is installed." }];

    private static IEnumerable<TheoryDataRow<string, string, string>> Rows(string compiler) =>
        from standard in compiler.EndsWith("++", StringComparison.Ordinal) ? (string[])["c++98", "c++20"] : ["c99", "c17"]
        from generation in (string[])["B18", "B12", "B10"]
        select new TheoryDataRow<string, string, string>(compiler, standard, generation);

    [Theory, MemberData(nameof(Compilers))]
    public async Task The_layout_is_that_of_the_wire(string compiler, string standard, string generation) =>
        await CompileAsync(compiler, standard, generation);

    [Theory, MemberData(nameof(Compilers))]
    public async Task The_layout_is_the_same_with_32_bits(string compiler, string standard, string generation)
    {
        Assert.SkipUnless(RuntimeInformation.OSArchitecture == Architecture.X64, "Only compilers for x64 compile for 32 bits, too.");
        await CompileAsync(compiler, standard, generation, "-m32", "-ffreestanding");
    }

    [Theory, MemberData(nameof(Compilers))]
    public async Task The_headers_compile_before_and_after_Windows_headers(string compiler, string standard, string generation)
    {
        Assert.SkipUnless(RuntimeInformation.OSArchitecture == Architecture.X64, "Only compilers for x64 compile for 32 bits, too.");
        await CompileAsync(compiler, standard, generation, [.. Windows, "-DLAYOUT_WINDOWS_FIRST"]);
        await CompileAsync(compiler, standard, generation, [.. Windows, "-DLAYOUT_WINDOWS_LAST"]);
    }

    // With a program's own definitions of common names, without ours, and with either header first.
    [Theory]
    [InlineData("B18")]
    [InlineData("B12")]
    [InlineData("B10")]
    public async Task The_headers_define_the_vendors_names(string generation)
    {
        foreach (string standard in (string[])["c99", "c2x", "c++98", "c++23"])
        {
            string compiler = standard.StartsWith("c++", StringComparison.Ordinal) ? "g++" : "gcc";
            foreach (string option in (string[])["-DPLAIN", "-DHOST_DEFINES", "-DNEURONDATAREADER_NO_BOOL", "-DCOMMANDS_FIRST"])
                await CompileFileAsync("names", compiler, standard, generation, option);
        }
    }

    [Fact]
    public async Task Compiler_options_that_change_the_layout_are_rejected()
    {
        (int code, _, string errors) = await SystemTool.RunAsync(
            "gcc", "-fsyntax-only", "-fshort-enums", "-x", "c", Path.Combine(NativeFiles.Headers, "DataType.h"));
        Assert.NotEqual(0, code);
        Assert.Contains("NeuronDataReader_RotateOrders_differs", errors, StringComparison.Ordinal);
    }

    private static Task CompileAsync(string compiler, string standard, string generation, params string[] options) =>
        CompileFileAsync("layout", compiler, standard, generation, options);

    private static async Task CompileFileAsync(string program, string compiler, string standard, string generation, params string[] options)
    {
        string source = Path.Combine(NativeFiles.Sources, program + (compiler.EndsWith("++", StringComparison.Ordinal) ? ".cpp" : ".c"));
        (int code, string output, string errors) = await SystemTool.RunAsync(
            compiler, [.. Strict, "-std=" + standard, "-DNEURONDATAREADER_" + generation, .. options, source]);
        Assert.Equal("", output + errors);
        Assert.Equal(0, code);
    }
}
