namespace NeuronMocap.Unity.Tests.Recorders;

public sealed class TakeFileNameTests : IDisposable
{
    private static readonly DateTime Now = new(2024, 5, 31, 14, 3, 9, DateTimeKind.Local);

    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("takes");

    public void Dispose() => _folder.Delete(recursive: true);

    [Theory]
    [InlineData("{source} {date} {time}", "Ann", "Ann 2024-05-31 14-03-09")]
    [InlineData("", "Ann", "Ann Take 001")]
    [InlineData("{name}", "Ann", "Take")]
    [InlineData("take {take}", "Ann", "take 001")]
    [InlineData("{source}", "a/b:c*d", "a-b-c-d")]
    [InlineData("{source}", "..", "take")]
    [InlineData("name. ", "Ann", "name")]
    public void A_pattern_becomes_a_name(string pattern, string source, string name) =>
        Assert.Equal(Path.Combine(_folder.FullName, name), TakeFileName.Create(_folder.FullName, pattern, source, Now, ".bvh"));

    [Theory]
    [InlineData("{name} {take}", "Shot", 7, "Shot 007", 7)]
    [InlineData("{name} {take}", "Shot", 3, "Shot 005", 5)]
    [InlineData("{name} {take}", " ", 0, "Take 001", 1)]
    [InlineData("{name}", "Shot 003", 9, "Shot 003 002", 9)]
    public void A_name_and_a_slate_are_part_of_the_pattern(string pattern, string name, int slate, string expected, int number)
    {
        File.WriteAllText(Path.Combine(_folder.FullName, "Shot 003.bvh"), "");
        File.WriteAllText(Path.Combine(_folder.FullName, "Shot 004.bvh"), "");
        var label = new TakeLabel(pattern, "Ann", name, slate, Now);
        Assert.Equal(0, label.Number);

        Assert.Equal(Path.Combine(_folder.FullName, expected), label.Create(_folder.FullName, ".bvh"));
        Assert.Equal(number, label.Number);
    }

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
