using System.Collections.Concurrent;
using System.Globalization;
using System.Runtime.InteropServices;
using System.Text;
using System.Threading.Channels;
using NeuronDataReaderWraper;
using NeuronMocap.Compatibility.Sockets;
using NeuronMocap.Tests.Vendor;

namespace NeuronMocap.Compatibility.Tests.Infrastructure;

/// <summary>The vendor's functions as C# programs call them, with the same lines as driver.c. A thread acts as the program's main thread.</summary>
internal sealed class ManagedDriver : VendorDriver
{
    private static readonly TimeSpan UsualPatience = VendorSocket.CloseTimeout;

    private readonly BlockingCollection<string> _calls = [];
    private readonly Channel<string> _lines = Channel.CreateUnbounded<string>();
    private readonly List<Reaction> _reactions = [];
    private readonly SemaphoreSlim _released = new(0);
    private readonly List<Exception> _failures = [];
    private readonly ConcurrentBag<IntPtr> _handles = [];
    private readonly Thread _main;

    /// <summary>Starts the main thread.</summary>
    /// <param name="isPatient">Whether closing waits until a running callback ends, instead of the usual short time.</param>
    public ManagedDriver(bool isPatient = false)
    {
        VendorSocket.CloseTimeout = isPatient ? Limits.Unexpected : UsualPatience;
        NeuronDataReader.BRRegisterFrameDataCallback('f', (custom, sender, header, data) => TellFrame("frame", custom, sender, header, data));
        NeuronDataReader.BRRegisterCalculationDataCallback('c', (custom, sender, header, data) => TellFrame("calculation", custom, sender, header, data));
        NeuronDataReader.BRRegisterSocketStatusCallback('s', TellStatus);
        CompatibilityEvents.CallbackFailed += OnFailed;
        _main = new Thread(() =>
        {
            foreach (string line in _calls.GetConsumingEnumerable())
                Run('=', IntPtr.Zero, line);
        })
        { IsBackground = true };
        _main.Start();
    }

    private string ThreadName =>
        Thread.CurrentThread == _main ? "main" : Environment.CurrentManagedThreadId.ToString(CultureInfo.InvariantCulture);

    public override async Task EndAsync()
    {
        await StopAsync();
        while (_lines.Reader.TryRead(out string? line))
            Keep(line);

        Assert.Empty(_failures);
    }

    public override async ValueTask DisposeAsync()
    {
        VendorSocket.CloseTimeout = UsualPatience;
        await StopAsync();
        foreach (IntPtr handle in _handles)
            NeuronDataReader.BRCloseSocket(handle);

        _released.Release(100);
        CompatibilityEvents.CallbackFailed -= OnFailed;
    }

    protected override void Write(string line) => _calls.Add(line);

    protected override Task<string> ReadAsync() => _lines.Reader.ReadAsync(TestContext.Current.CancellationToken).Soon();

    // As when a process ends: no callback is called any more.
    private async Task StopAsync()
    {
        NeuronDataReader.BRRegisterFrameDataCallback(IntPtr.Zero, null);
        NeuronDataReader.BRRegisterCalculationDataCallback(IntPtr.Zero, null);
        NeuronDataReader.BRRegisterSocketStatusCallback(IntPtr.Zero, null);
        _calls.CompleteAdding();
        await Task.Run(_main.Join).Soon();
    }

    private void Say(string line) => Assert.True(_lines.Writer.TryWrite(line));

    private void OnFailed(Exception exception)
    {
        lock (_failures)
            _failures.Add(exception);
    }

    private void TellFrame(string kind, IntPtr custom, IntPtr sender, IntPtr header, IntPtr data)
    {
        byte[] image = Copy(header, 64);
        int count = kind == "frame" ? BitConverter.ToUInt16(image, 6) : BitConverter.ToInt32(image, 6);
        string hash = DriverFrame.HashOf(Copy(data, 4 * count));
        Say($"{kind} {(char)custom} {Name(sender)} {ThreadName} 0x{header:x} 0x{data:x} {Convert.ToHexString(image)} {hash}");
        React(kind, "", sender);
        if (!Copy(header, 64).AsSpan().SequenceEqual(image) || DriverFrame.HashOf(Copy(data, 4 * count)) != hash)
            Say($"overwritten {Name(sender)}");
    }

    private void TellStatus(IntPtr custom, IntPtr sender, SocketStatus status, string message)
    {
        Say($"status {(char)custom} {Name(sender)} {ThreadName} {(int)status} {message.Replace("\n", "\\n", StringComparison.Ordinal)}");
        React("status", message, sender);
    }

    private void React(string kind, string text, IntPtr sender)
    {
        Reaction[] taken;
        lock (_reactions)
        {
            taken = [.. _reactions.Where(reaction => reaction.Kind == kind && text.StartsWith(reaction.Text, StringComparison.Ordinal))];
            _reactions.RemoveAll(reaction => reaction.Once && taken.Contains(reaction));
        }

        foreach (Reaction reaction in taken)
            Run('!', sender, reaction.Line);
    }

    private void Run(char mark, IntPtr sender, string line)
    {
        string[] words = line.Split(' ');
        IntPtr handle = words.Length < 2 ? IntPtr.Zero : words[1] == "sender" ? sender : HandleOf(words[1]);
        switch (words[0])
        {
            case "connect":
                Answer(Name(Kept(NeuronDataReader.BRConnectTo(HostOf(words[1])!, Number(words[2])))));
                break;
            case "connect-commands":
                Answer(Name(Kept(NeuronDataReader.BRConnectCmd(HostOf(words[1])!, Number(words[2])))));
                break;
            case "udp":
                Answer(Name(Kept(NeuronDataReader.BRStartUDPServiceAt(Number(words[1])))));
                break;
            case "close":
                NeuronDataReader.BRCloseSocket(handle);
                Answer("closed");
                break;
            case "get-status":
                Answer($"{(int)NeuronDataReader.BRGetSocketStatus(handle)}");
                break;
            case "zero-out":
                Answer(Result(NeuronDataReader.ZeroOut(handle, Number(words[2]))));
                break;
            case "zero-out-all":
                Answer(Result(NeuronDataReader.ZeroOutAll(handle)));
                break;
            case "rotation":
                Answer($"{Result(NeuronDataReader.GetBvhRotation(handle, out RotateOrders order))} order {(int)order}");
                break;
            case "bone-size":
                Answer($"{Result(NeuronDataReader.GetBoneSize(handle, Number(words[2]), out BoneDimension size))} {Text(size)}");
                break;
            case "header":
                Answer(AskForHeader(handle, Number(words[2]), Number(words[3])));
                break;
            case "error":
                Answer(NeuronDataReader.strBRGetLastErrorMessage());
                break;
            case "when" or "whenever":
                string[] kind = words[1].Split(':');
                lock (_reactions)
                    _reactions.Add(new(kind[0], kind.ElementAtOrDefault(1) ?? "", string.Join(' ', words[2..]), words[0] == "when"));

                Answer("added");
                break;
            case "thread":
                new Thread(() => Run('!', IntPtr.Zero, string.Join(' ', words[1..]))) { IsBackground = true }.Start();
                Answer("started");
                break;
            case "hold":
                Answer("held");
                _released.Wait();
                Answer("released");
                break;
            case "release":
                _released.Release();
                Answer("done");
                break;
            default:
                Say($"? {line}");
                break;
        }

        void Answer(string answer) => Say($"{mark} {answer}");
    }

    private IntPtr Kept(IntPtr handle)
    {
        _handles.Add(handle);
        return handle;
    }

    // Returns what the call wrote to a buffer of so many 'x' bytes, and to the byte after it, which it must not touch.
    private static string AskForHeader(IntPtr handle, int avatar, int length)
    {
        byte[] room = [.. Enumerable.Repeat((byte)'x', Math.Max(0, length) + 1)];
        string told = Result(NeuronDataReader.GetBvhHeader(handle, avatar, room, length));
        string text = Encoding.Latin1.GetString(room.AsSpan(..^1)).Replace("\n", "\\n", StringComparison.Ordinal);
        int end = text.IndexOf('\0', StringComparison.Ordinal);
        return $"{told} {(end < 0 ? text : text[..end] + "\\0")}{(room[^1] == 'x' ? "" : " OVERRUN")}";
    }

    private static string Result(bool told) => told ? "1" : "0";

    private static string Text(BoneDimension size) => string.Join(
        ' ', MemoryMarshal.Cast<BoneDimension, float>(MemoryMarshal.CreateReadOnlySpan(in size, 1)).ToArray().Select(static value => value.ToString("G9", CultureInfo.InvariantCulture)));

    private static byte[] Copy(IntPtr memory, int count)
    {
        byte[] bytes = new byte[count];
        Marshal.Copy(memory, bytes, 0, count);
        return bytes;
    }

    private static string Name(IntPtr handle) => handle == IntPtr.Zero ? None : $"0x{handle:x}";

    private static IntPtr HandleOf(string word) =>
        IntPtr.TryParse(word.AsSpan(Math.Min(2, word.Length)), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out IntPtr handle) ? handle : IntPtr.Zero;

    private static string? HostOf(string word) => word switch { "null" => null, "empty" => "", _ => word };

    private static int Number(string word) => int.Parse(word, CultureInfo.InvariantCulture);

    // A line to run when a callback of a kind receives a text with this start: once, or every time.
    private sealed record Reaction(string Kind, string Text, string Line, bool Once);
}
