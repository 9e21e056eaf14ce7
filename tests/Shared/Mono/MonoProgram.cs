using System.Diagnostics;
using Mono.Cecil;

namespace NeuronMocap.Tests.Mono;

/// <summary>
/// Debian's Mono, the closest available runtime to that of Unity's editor. Compiles a program of C# files against copies of the netstandard2.1
/// assemblies, and runs it.
/// </summary>
/// <param name="others">Assemblies that the program references in addition to the library's.</param>
internal sealed class MonoProgram(params string[] others) : IDisposable
{
    private const string Runtime = "/usr/bin/mono";
    private const string Compiler = "/usr/bin/mcs";
    private const int Aborted = 134;
    private const string Facade = "/usr/lib/mono/4.5/Facades/netstandard.dll";

    // A program that does many things one after the other takes 10 s, and several times that on a busy computer.
    private static readonly TimeSpan Limit = 10 * Limits.Unexpected;

    private readonly string[] _assemblies = ["NeuronMocap.dll", "NeuronMocap.Server.dll", "NeuronMocap.Compatibility.dll", .. others];

    private readonly string _folder = Directory.CreateTempSubdirectory("neuron-mocap-mono-").FullName;

    private string Executable => Path.Combine(_folder, "program.exe");

    public static void Require() => Assert.SkipUnless(
        File.Exists(Runtime) && File.Exists(Compiler) && File.Exists(Facade), "Mono and its compiler are not installed (Debian's mono-devel).");

    public async Task CompileAsync(string text)
    {
        string source = Path.Combine(_folder, "program.cs");
        await File.WriteAllTextAsync(source, text, TestContext.Current.CancellationToken);
        await CompileAsync([source]);
    }

    public async Task CompileAsync(IEnumerable<string> sources)
    {
        foreach (string assembly in _assemblies)
            Adapt(Path.Combine(AppContext.BaseDirectory, assembly), Path.Combine(_folder, assembly));

        IEnumerable<string> references = _assemblies.Select(assembly => "-r:" + Path.Combine(_folder, assembly));
        await RunAsync(Compiler, ["-warnaserror", "-r:" + Facade, .. references, "-out:" + Executable, .. sources]);
    }

    /// <summary>Compiles one of the programs beside this file.</summary>
    public Task CompileProgramAsync(string name) =>
        CompileAsync([Repository.PathOf("tests", "NeuronMocap.Compatibility.Tests", "Mono", "Programs", name + ".mono.cs")]);

    public Task<string[]> RunAsync(params string[] arguments) => RunAsync(Runtime, [Executable, .. arguments]);

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    // References to members of ReadOnlySpan with read-only results carry a modifier. Debian built Mono's own library without that modifier, so Mono
    // does not find the members. Unity's library has it.
    private static void Adapt(string source, string target)
    {
        using var module = ModuleDefinition.ReadModule(source, new ReaderParameters(ReadingMode.Immediate));
        IEnumerable<MethodReference> called = module.GetTypes()
            .SelectMany(static type => type.Methods)
            .Where(static method => method.HasBody)
            .SelectMany(static method => method.Body.Instructions)
            .Select(static instruction => instruction.Operand)
            .OfType<MethodReference>();
        foreach (MethodReference method in called)
        {
            if (method.GetElementMethod() is { ReturnType: RequiredModifierType { ModifierType.Name: "InAttribute" } modified } reference)
                reference.ReturnType = modified.ElementType;
        }

        module.Write(target);
    }

    private static async Task<string[]> RunAsync(string program, string[] arguments)
    {
        var start = new ProcessStartInfo(program) { UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true };
        foreach (string argument in arguments)
            start.ArgumentList.Add(argument);

        using Process process = Process.Start(start)!;
        Task<string> output = process.StandardOutput.ReadToEndAsync(TestContext.Current.CancellationToken);
        Task<string> error = process.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken);
        try
        {
            await process.WaitForExitAsync(TestContext.Current.CancellationToken).WaitAsync(Limit, TestContext.Current.CancellationToken);
        }
        finally
        {
            if (!process.HasExited)
                process.Kill();
        }

        string text = await output.Soon();
        string[] lines = text.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        int fault = process.ExitCode == Aborted ? Array.FindIndex(lines, IsFaultOfShutdown) : -1;
        Assert.True(process.ExitCode == 0 || fault >= 0, $"{program} ended with {process.ExitCode}: {text}{await error.Soon()}");
        return fault >= 0 ? lines[..fault] : lines;
    }

    // Mono 6.8 sometimes aborts after the end of the program, when it stops a thread and cannot create the exception for it. The output of the program is
    // complete then, and lines of Mono follow.
    private static bool IsFaultOfShutdown(string line) =>
        line.StartsWith("* Assertion at ", StringComparison.Ordinal) && line.Contains("type:ThreadAbortException", StringComparison.Ordinal);
}
