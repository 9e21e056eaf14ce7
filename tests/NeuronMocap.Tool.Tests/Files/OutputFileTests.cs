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
}
