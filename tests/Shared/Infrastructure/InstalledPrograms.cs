namespace NeuronMocap.Tests.Infrastructure;

/// <summary>Finds programs where a shell looks for them.</summary>
internal static class InstalledPrograms
{
    public static bool Have(string name) => PathOf(name) is not null;

    public static string? PathOf(string name) => (Environment.GetEnvironmentVariable("PATH") ?? string.Empty)
        .Split(Path.PathSeparator)
        .SelectMany(folder => (string[])[Path.Combine(folder, name), Path.Combine(folder, name + ".exe")])
        .FirstOrDefault(File.Exists);
}
