namespace NeuronMocap.Data.Tests;

public sealed class DataFolderTests
{
    [Fact]
    public void The_folder_holds_recordings()
    {
        Assert.SkipUnless(Fixtures.Exists, "There is no folder shared/data beside the repository: the tests with recordings of real suits are skipped.");
        Assert.All((string[])["streams", "calc", "test-take"], static folder => Assert.NotEmpty(Directory.GetFiles(Path.Combine(Fixtures.Folder, folder))));
    }
}
