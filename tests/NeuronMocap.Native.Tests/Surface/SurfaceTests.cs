namespace NeuronMocap.Native.Tests.Surface;

// Compares the C surface with tests/NeuronMocap.Tests/PublicApi/libNeuronDataReader.txt, whose diff shows how a change affects users.
public sealed class SurfaceTests
{
    private const string UpdateVariable = "NEURONMOCAP_UPDATE_API";

    [Fact]
    public async Task The_C_API_matches_its_file()
    {
        IReadOnlyList<string> newest = await CSurface.DeclarationsAsync("B18");
        IReadOnlyList<string> old = await CSurface.DeclarationsAsync("B12");
        string[] exports = await CSurface.ExportsAsync();
        string[] actual =
        [
            .. newest.Select(line => old.Contains(line, StringComparer.Ordinal) ? line : "[b18] " + line),
            .. old.Except(newest, StringComparer.Ordinal).Select(static line => "[b12] " + line),
            .. exports.Select(static name => "export " + name),
        ];

        string path = Repository.PathOf("tests", "NeuronMocap.Tests", "PublicApi", "libNeuronDataReader.txt");
        if (Environment.GetEnvironmentVariable(UpdateVariable) is "1")
            await File.WriteAllLinesAsync(path, actual, TestContext.Current.CancellationToken);

        string[] expected = await File.ReadAllLinesAsync(path, TestContext.Current.CancellationToken);
        Assert.True(
            expected.SequenceEqual(actual, StringComparer.Ordinal),
            $"""
            The C surface differs from {path}:
            {string.Join('\n', expected.Except(actual, StringComparer.Ordinal).Select(static line => "- " + line))}
            {string.Join('\n', actual.Except(expected, StringComparer.Ordinal).Select(static line => "+ " + line))}
            If that is meant, run this test with {UpdateVariable}=1 to rewrite the file, and commit it with the change.
            """);
    }

    [Fact]
    public async Task Exactly_the_functions_of_the_headers_are_exported()
    {
        IEnumerable<string> declared = CSurface.Functions(await CSurface.DeclarationsAsync("B18"))
            .Union(CSurface.Functions(await CSurface.DeclarationsAsync("B12")), StringComparer.Ordinal);
        Assert.Equal(declared.Order(StringComparer.Ordinal), await CSurface.ExportsAsync());
    }

    // Without a macro, the newest generation applies. The headers do not know the macro B18.
    [Fact]
    public async Task The_old_header_declares_the_newest_functions()
    {
        string[] newest = [.. CSurface.Functions(await CSurface.DeclarationsAsync("B18"))];
        string[] old = [.. CSurface.Functions(await CSurface.DeclarationsAsync("B12"))];
        Assert.Equal(16, newest.Length);
        Assert.Equal(5, old.Except(newest, StringComparer.Ordinal).Count());
        Assert.Empty(newest.Except(old, StringComparer.Ordinal));
    }
}
