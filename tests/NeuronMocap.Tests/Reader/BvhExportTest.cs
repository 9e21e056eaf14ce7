using NeuronMocap.Bvh;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

// A reader that exports frames of a test server to its own file.
public abstract class BvhExportTest : IDisposable
{
    private protected static readonly BvhExportOptions Patient = new() { HeaderTimeout = Limits.Unexpected };

    private protected DirectoryInfo Folder { get; } = Directory.CreateTempSubdirectory("neuronmocap");

    private protected TestServer Server { get; } = new();

    private protected string Target => Path.Combine(Folder.FullName, "take.bvh");

    public void Dispose()
    {
        Server.Dispose();
        Folder.Delete(recursive: true);
        GC.SuppressFinalize(this);
    }

    // Sends packets to a reader whose connection then ends.
    private protected async Task<BvhExport> ExportAsync(byte[][] packets, BvhExportOptions? options = null, int? commandPort = null)
    {
        NeuronReaderOptions readerOptions = Server.Options();
        readerOptions.CommandPort = commandPort;
        await using var reader = new NeuronReader(readerOptions);
        using BvhExport export = reader.ExportBvh(Target, options);
        reader.Start();
        using TestConnection connection = await Server.AcceptAsync();
        foreach (byte[] packet in packets)
            await connection.SendAsync(packet);

        // After its connection ends, a reader asks nothing more.
        if (commandPort is not null)
            await Limits.UntilAsync(() => export.FramesWritten > 0);

        connection.Close();
        await export.Completion.Soon();
        return export;
    }
}
