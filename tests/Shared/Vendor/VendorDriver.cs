using System.Globalization;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Vendor;

/// <summary>A frame as passed to a callback. Thread is "main" or a number. Hash is that of the floats' bytes.</summary>
internal sealed record DriverFrame(string Object, string Sender, string Thread, ulong HeaderAddress, ulong DataAddress, byte[] Header, string Hash)
{
    public uint FrameIndex => BitConverter.ToUInt32(Header, 46);

    public static DriverFrame Read(string[] words) =>
        new(words[1], words[2], words[3], AddressOf(words[4]), AddressOf(words[5]), Convert.FromHexString(words[6]), words[7]);

    // FNV-1a, as in driver.c.
    public static string HashOf(ReadOnlySpan<byte> bytes)
    {
        ulong value = 14_695_981_039_346_656_037;
        foreach (byte part in bytes)
            value = unchecked((value ^ part) * 1_099_511_628_211);
        return value.ToString("X16", CultureInfo.InvariantCulture);
    }

    private static ulong AddressOf(string word) => ulong.Parse(word.AsSpan(2), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture);
}

/// <summary>
/// A status as passed to a callback: its number and its text, with line feeds as \n. FramesBefore is the number of frames received before.
/// </summary>
internal sealed record DriverStatus(string Object, string Sender, string Thread, string Line, int FramesBefore);

/// <summary>
/// A program that calls the vendor's functions on command, line by line, and reports the results of functions and callbacks in lines. driver.c in
/// tests/native describes the lines.
/// </summary>
internal abstract class VendorDriver : IAsyncDisposable
{
    public const string None = "(nil)";

    private readonly Queue<string> _answers = [];

    public List<DriverFrame> Frames { get; } = [];

    public List<DriverFrame> Calculations { get; } = [];

    public List<DriverStatus> Statuses { get; } = [];

    /// <summary>The results of lines that callbacks ran.</summary>
    public List<string> Reactions { get; } = [];

    public IEnumerable<string> LinesOf(string sender) => Statuses.Where(status => status.Sender == sender).Select(static status => status.Line);

    /// <summary>Writes a line and returns its result. Callbacks reported before the result are kept.</summary>
    public async Task<string> CallAsync(string line)
    {
        Write(line);
        await UntilAsync(() => _answers.Count > 0);
        return _answers.Dequeue();
    }

    public Task<string> ConnectAsync(int port, string host = "127.0.0.1") => CallAsync(FormattableString.Invariant($"connect {host} {port}"));

    public async Task<(string Handle, TestConnection Connection)> ConnectAsync(TestServer server)
    {
        string handle = await ConnectAsync(server.Port);
        Assert.NotEqual(None, handle);
        return (handle, await server.AcceptAsync());
    }

    /// <summary>Reads the program's output until the condition holds.</summary>
    public async Task UntilAsync(Func<bool> condition)
    {
        while (!condition())
            Keep(await ReadAsync());
    }

    public Task FramesAsync(int count) => UntilAsync(() => Frames.Count >= count);

    public Task StatusesAsync(int count) => UntilAsync(() => Statuses.Count >= count);

    /// <summary>Ends the program, which must exit without an error.</summary>
    public abstract Task EndAsync();

    public abstract ValueTask DisposeAsync();

    protected abstract void Write(string line);

    protected abstract Task<string> ReadAsync();

    protected void Keep(string line)
    {
        string[] words = line.Split(' ');
        switch (words[0])
        {
            case "=":
                _answers.Enqueue(line[2..]);
                break;
            case "!":
                Reactions.Add(line[2..]);
                break;
            case "frame":
                Frames.Add(DriverFrame.Read(words));
                break;
            case "calculation":
                Calculations.Add(DriverFrame.Read(words));
                break;
            case "status":
                Statuses.Add(new DriverStatus(words[1], words[2], words[3], string.Join(' ', words[4..]), Frames.Count));
                break;
            default:
                Assert.Fail(line);
                break;
        }
    }
}
