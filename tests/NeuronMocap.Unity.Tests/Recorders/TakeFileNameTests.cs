namespace NeuronMocap.Unity.Tests.Recorders;

public sealed class TakeFileNameTests : IDisposable
{
    private static readonly DateTime Now = new(2024, 5, 31, 14, 3, 9, DateTimeKind.Local);

    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("takes");

    public void Dispose() => _folder.Delete(recursive: true);

    [Theory]
    [InlineData("{source} {date} {time}", "Ann", "Ann 2024-05-31 14-03-09")]
    [InlineData("", "Ann", "Ann 2024-05-31 14-03-09")]
    [InlineData("take {take}", "Ann", "take 001")]
    [InlineData("{source}", "a/b:c*d", "a-b-c-d")]
    [InlineData("{source}", "..", "take")]
    [InlineData("name. ", "Ann", "name")]
    public void A_pattern_becomes_a_name(string pattern, string source, string name) =>
        Assert.Equal(Path.Combine(_folder.FullName, name), TakeFileName.Create(_folder.FullName, pattern, source, Now, ".bvh"));

    [Fact]
    public void No_take_replaces_another()
    {
        File.WriteAllText(Path.Combine(_folder.FullName, "a.bvh"), "");
        File.WriteAllText(Path.Combine(_folder.FullName, "take 001-avatar0.bvh"), "");
        File.WriteAllText(Path.Combine(_folder.FullName, "take 002.nmrec"), "");

        Assert.EndsWith("a 002", TakeFileName.Create(_folder.FullName, "a", "", Now, ".bvh", ".nmrec"));
        Assert.EndsWith("take 003", TakeFileName.Create(_folder.FullName, "take {take}", "", Now, ".bvh", ".nmrec"));
    }
}
