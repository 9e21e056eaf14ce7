using NeuronMocap.Bvh;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

// A reader that exports to a file of its own what a server of the test sends.
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

    // Sends packets to a reader whose connection ends after them.
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

        // A reader whose connection has ended asks nothing more.
        if (commandPort is not null)
            await Limits.UntilAsync(() => export.FramesWritten > 0);

        connection.Close();
        await export.Completion.Soon();
        return export;
    }
}
