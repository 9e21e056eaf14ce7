namespace NeuronMocap.Tests.Infrastructure;

// A link to the device that is always full. The library gives a file one writer at a time, and every test program has the same device, so they take turns.
internal sealed class FullDevice : IDisposable
{
    private const string Device = "/dev/full";

    // Users cannot open each other's files.
    private static readonly string TurnFile = Path.Combine(Path.GetTempPath(), $"neuron-mocap-full-device-{Environment.UserName}");

    private readonly FileStream _turn;

    private FullDevice(FileStream turn) => _turn = turn;

    // Skips the test on a system without the device. Each turn ends, however slow the others are, so the wait has no limit.
    public static async Task<FullDevice> LinkAsync(string link)
    {
        Assert.SkipUnless(File.Exists(Device), $"This system has no {Device}.");
        FileStream? turn;
        while ((turn = TryTakeTurn()) is null)
            await Task.Delay(5, TestContext.Current.CancellationToken);

        File.CreateSymbolicLink(link, Device);
        return new FullDevice(turn);
    }

    public void Dispose() => _turn.Dispose();

    private static FileStream? TryTakeTurn()
    {
        try
        {
            return new FileStream(TurnFile, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None);
        }
        catch (IOException)
        {
            return null;
        }
    }
}
