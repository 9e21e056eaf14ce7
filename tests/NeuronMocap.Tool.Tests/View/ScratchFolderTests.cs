using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.Tests.View;

public sealed class ScratchFolderTests
{
    // Other tests start programs, which look at the same folders. A folder is too new for them until its file "used" is old.
    [Fact]
    public async Task A_folder_of_a_program_that_was_killed_goes_with_the_next_start()
    {
        // The lock of a killed program is free, and its files are still there.
        DirectoryInfo killed = Directory.CreateTempSubdirectory("neuron-mocap-view-");
        DirectoryInfo files = killed.CreateSubdirectory("files");
        File.WriteAllText(Path.Combine(files.FullName, ScratchFolder.NewName()), "a take");
        File.WriteAllText(Path.Combine(files.FullName, ScratchFolder.NewName() + ".glb"), "a download");
        MarkAsOld(killed);

        using var first = new ScratchFolder(1000);
        await Limits.UntilAsync(() => !Directory.Exists(killed.FullName));

        string path = Path.Combine(first.Path, ScratchFolder.NewName());
        File.WriteAllText(path, "in use");
        using var second = new ScratchFolder(1000);
        Assert.True(File.Exists(path));
    }

    [Fact]
    public void A_folder_with_files_of_others_stays()
    {
        DirectoryInfo other = Directory.CreateTempSubdirectory("neuron-mocap-view-");
        try
        {
            string file = Path.Combine(other.CreateSubdirectory("files").FullName, "notes.txt");
            File.WriteAllText(file, "not of this program");
            MarkAsOld(other);

            using var scratch = new ScratchFolder(1000);

            Assert.True(File.Exists(file));
        }
        finally
        {
            Remove(other);
        }
    }

    // A program that starts at the same instant has made its file and has not locked it yet.
    [Fact]
    public void A_folder_of_a_program_that_starts_stays()
    {
        DirectoryInfo starting = Directory.CreateTempSubdirectory("neuron-mocap-view-");
        try
        {
            File.WriteAllText(Path.Combine(starting.FullName, "used"), string.Empty);

            using var scratch = new ScratchFolder(1000);

            Assert.True(Directory.Exists(starting.FullName));
        }
        finally
        {
            Remove(starting);
        }
    }

    [Fact]
    public void Its_end_deletes_everything()
    {
        string path;
        using (var scratch = new ScratchFolder(1000))
        {
            path = scratch.Path;
            File.WriteAllText(Path.Combine(path, ScratchFolder.NewName()), "a take");
        }

        Assert.False(Directory.Exists(path));
        Assert.False(Directory.Exists(Path.GetDirectoryName(path)));
    }

    // A program that another test starts can delete the mark in the folder at the same instant.
    private static void Remove(DirectoryInfo folder)
    {
        try
        {
            folder.Delete(recursive: true);
        }
        catch (IOException)
        {
            folder.Delete(recursive: true);
        }
    }

    private static void MarkAsOld(DirectoryInfo folder)
    {
        string mark = Path.Combine(folder.FullName, "used");
        File.WriteAllText(mark, string.Empty);
        File.SetLastWriteTimeUtc(mark, DateTime.UtcNow.AddHours(-1));
    }
}
