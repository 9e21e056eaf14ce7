using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Tests.Files;

public sealed class OutputFileTests
{
    // The writing thread may reach the file just after the run was given up.
    [Fact]
    public void A_file_created_after_cancellation_is_removed()
    {
        using var folder = new TemporaryFolder();
        using var output = new OutputFile(folder["take.bvh"], overwrite: false);
        Assert.Throws<OperationCanceledException>(() => output.Write(path =>
        {
            output.Dispose();
            File.WriteAllText(path, "half of it");
        }));

        Assert.Empty(folder.Names);
    }

    [Fact]
    public void A_symbolic_link_stays_and_its_target_is_replaced()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "Symbolic links need a permission there.");
        using var folder = new TemporaryFolder();
        Directory.CreateDirectory(folder["takes"]);
        File.WriteAllText(folder["takes/1.csv"], "old");
        File.CreateSymbolicLink(folder["latest.csv"], "takes/1.csv");
        File.CreateSymbolicLink(folder["next.csv"], "takes/2.csv");
        Write(folder["latest.csv"], overwrite: true);
        Write(folder["next.csv"], overwrite: true);

        Assert.Equal(["1.csv", "2.csv"], Directory.GetFiles(folder["takes"]).Select(Path.GetFileName).Order(StringComparer.Ordinal));
        Assert.Equal("new", File.ReadAllText(folder["takes/1.csv"]));
        Assert.Equal("new", File.ReadAllText(folder["takes/2.csv"]));
        Assert.Equal("takes/1.csv", new FileInfo(folder["latest.csv"]).LinkTarget);
    }

    [Fact]
    public void A_link_into_a_missing_folder_is_an_error_that_names_the_folder()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "Symbolic links need a permission there.");
        using var folder = new TemporaryFolder();
        File.CreateSymbolicLink(folder["a.csv"], folder["takes/a.csv"]);
        IOException exception = Assert.Throws<IOException>(() => Write(folder["a.csv"], overwrite: true));
        Assert.Equal($"'{folder["takes"]}', the folder for 'a.csv', does not exist.", exception.Message);
        Assert.Equal(["a.csv"], folder.Names);
    }

    [Fact]
    public void A_link_in_a_circle_is_an_error_that_names_it()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "Symbolic links need a permission there.");
        using var folder = new TemporaryFolder();
        File.CreateSymbolicLink(folder["a.csv"], "b.csv");
        File.CreateSymbolicLink(folder["b.csv"], "a.csv");
        IOException exception = Assert.Throws<IOException>(() => Write(folder["a.csv"], overwrite: true));
        Assert.Contains("a.csv", exception.Message, StringComparison.Ordinal);
        Assert.Equal(["a.csv", "b.csv"], folder.Names);
    }

    [Fact]
    public void A_replaced_file_keeps_its_permissions()
    {
        if (OperatingSystem.IsWindows())
        {
            Assert.Skip("Windows has other permissions.");
            return;
        }

        const UnixFileMode Private = UnixFileMode.UserRead | UnixFileMode.UserWrite;
        using var folder = new TemporaryFolder();
        File.WriteAllText(folder["take.csv"], "old");
        File.SetUnixFileMode(folder["take.csv"], Private);
        Write(folder["take.csv"], overwrite: true);
        Assert.Equal(Private, File.GetUnixFileMode(folder["take.csv"]));
    }

    // A script that reads *.csv would otherwise find half of a table.
    [Fact]
    public void An_unfinished_file_has_another_extension()
    {
        using var folder = new TemporaryFolder();
        using var output = new OutputFile(folder["take.csv"], overwrite: false);
        output.Write(path =>
        {
            File.WriteAllText(path, "new");
            Assert.Empty(Directory.GetFiles(Path.GetDirectoryName(path)!, "*.csv"));
        });
        Assert.Equal(["take.csv"], folder.Names);
    }

    private static void Write(string path, bool overwrite)
    {
        using var output = new OutputFile(path, overwrite);
        output.Write(static temporary => File.WriteAllText(temporary, "new"));
    }
}
