using System.Reflection;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Loader;
using NeuronDataReaderWraper;
using NeuronMocap.Compatibility.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Compatibility.Tests.Callbacks;

// The process has one callback of each kind: registered, replaced, unregistered, throwing.
public sealed class CallbackTests
{
    [Fact]
    public async Task A_replacing_callback_gets_its_own_object()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        var objects = new List<long>();
        NeuronDataReader.BRRegisterFrameDataCallback(21, (customObject, _, _, _) => Add(objects, customObject));
        await server.SendAsync(TestPackets.Motion(1));
        await Limits.UntilAsync(() => Count(objects) == 1);

        NeuronDataReader.BRRegisterFrameDataCallback(22, (customObject, _, _, _) => Add(objects, customObject));
        await server.SendAsync(TestPackets.Motion(2));
        await Limits.UntilAsync(() => Count(objects) == 2);

        Assert.Equal([21, 22], objects);
        Assert.Empty(log.Frames);
    }

    [Fact]
    public async Task Frames_are_ignored_without_a_callback()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        NeuronDataReader.BRRegisterFrameDataCallback(IntPtr.Zero, null);

        await server.SendAsync(TestPackets.Motion(1), TestPackets.Calculation(1));
        await Limits.UntilAsync(() => log.CalculationFrames.Count == 1);
        NeuronDataReader.BRRegisterCalculationDataCallback(IntPtr.Zero, null);
        var arrived = new List<long>();
        NeuronDataReader.BRRegisterFrameDataCallback(23, (customObject, _, _, _) => Add(arrived, customObject));
        await server.SendAsync(TestPackets.Calculation(2), TestPackets.Motion(2));
        await Limits.UntilAsync(() => Count(arrived) == 1);

        Assert.Empty(log.Frames);
        Assert.Single(log.CalculationFrames);
    }

    [Fact]
    public async Task A_callback_may_replace_and_unregister_itself()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        var objects = new List<long>();
        NeuronDataReader.BRRegisterFrameDataCallback(31, (first, _, _, _) =>
        {
            Add(objects, first);
            NeuronDataReader.BRRegisterFrameDataCallback(32, (second, _, _, _) =>
            {
                Add(objects, second);
                NeuronDataReader.BRRegisterFrameDataCallback(IntPtr.Zero, null);
            });
        });

        await server.SendAsync(TestPackets.Motion(1), TestPackets.Motion(2), TestPackets.Motion(3), TestPackets.Calculation(4));
        await Limits.UntilAsync(() => log.CalculationFrames.Count == 1);

        Assert.Equal([31, 32], objects);
    }

    // Like the managed wrapper, whose callbacks are public fields.
    [Fact]
    public async Task A_callback_may_be_added_to_the_field()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        var objects = new List<long>();
        FrameDataReceived added = (customObject, _, _, _) => Add(objects, customObject);
        NeuronDataReader.frameDataReceivedCallback += added;

        await server.SendAsync(TestPackets.Motion(1));
        await log.FramesAsync(1);
        await Limits.UntilAsync(() => Count(objects) == 1);
        NeuronDataReader.frameDataReceivedCallback -= added;
        await server.SendAsync(TestPackets.Motion(2));
        await log.FramesAsync(2);

        Assert.Equal([CallbackLog.FrameObject], objects);
    }

    // The other namespace acts as another library.
    [Fact]
    public async Task Each_namespace_has_its_own_callbacks_and_connections()
    {
        using var server = new TestServer();
        using var log = new CallbackLog();
        var frames = new List<long>();
        NeuronDataReaderManaged.NeuronDataReader.BRRegisterFrameDataCallback(41, (customObject, _, _, _) => Add(frames, customObject));
        IntPtr native = log.Connect(server.Port);
        using TestConnection first = await server.AcceptAsync();
        IntPtr managed = NeuronDataReaderManaged.NeuronDataReader.BRConnectTo("127.0.0.1", server.Port);
        using TestConnection second = await server.AcceptAsync();
        Assert.NotEqual(native, managed);

        await second.SendAsync(TestPackets.Motion(1));
        await Limits.UntilAsync(() => Count(frames) == 1);
        await first.SendAsync(TestPackets.Motion(2));
        await log.FramesAsync(1);

        Assert.Equal([41], frames);
        Assert.Equal(native, Assert.Single(log.Frames).Socket);
        NeuronDataReaderManaged.NeuronDataReader.BRCloseSocket(managed);
        NeuronDataReaderManaged.NeuronDataReader.BRRegisterFrameDataCallback(IntPtr.Zero, null);
    }

    // In the native library, such a delegate is collected, and the next frame ends the process.
    [Fact]
    public async Task A_registered_delegate_is_not_collected()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        var frames = new List<long>();
        RegisterTemporary(frames);
        GC.Collect();
        GC.WaitForPendingFinalizers();
        GC.Collect();

        await server.SendAsync(TestPackets.Motion(1));
        await Limits.UntilAsync(() => Count(frames) == 1);
    }

    [Fact]
    public async Task A_callback_exception_is_reported_and_the_connection_goes_on()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        var fault = new InvalidOperationException("The script is wrong.");
        log.OnFrame = _ => throw fault;

        await server.SendAsync(TestPackets.Motion(1), TestPackets.Motion(2), TestPackets.Motion(3));
        await Limits.UntilAsync(() => log.Failures.Count == 3);

        Assert.All(log.Failures, failure => Assert.Same(fault, failure));
        Assert.Equal(3, log.Frames.Count);
        Assert.Equal(SocketStatus.CS_Running, NeuronDataReader.BRGetSocketStatus(server.Socket));
    }

    [Fact]
    public void A_status_callback_exception_does_not_stop_connecting_or_closing()
    {
        using var server = new TestServer();
        using var log = new CallbackLog();
        log.OnStatus = static _ => throw new InvalidOperationException("The script is wrong.");

        IntPtr socket = log.Connect(server.Port);
        Assert.NotEqual(IntPtr.Zero, socket);
        NeuronDataReader.BRCloseSocket(socket);

        Assert.Equal(3, log.Statuses.Count);
        Assert.Equal(3, log.Failures.Count);
    }

    [Fact]
    public async Task Unhandled_callback_exceptions_are_traced_at_intervals()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        var frames = new List<long>();
        TextWriter error = Console.Error;
        using var written = new StringWriter();
        try
        {
            Console.SetError(TextWriter.Synchronized(written));
            using (new Unheard())
            {
                NeuronDataReader.BRRegisterFrameDataCallback(1, (customObject, _, _, _) =>
                {
                    Add(frames, customObject);
                    throw new InvalidOperationException("The script is wrong.");
                });
                await server.SendAsync(TestPackets.Motion(1), TestPackets.Motion(2), TestPackets.Motion(3));
                await Limits.UntilAsync(() => Count(frames) == 3);
                NeuronDataReader.BRCloseSocket(server.Socket);
            }
        }
        finally
        {
            Console.SetError(error);
        }

        Assert.Equal(1, written.ToString().Split("The script is wrong.").Length - 1);
        Assert.StartsWith("NeuronMocap: a callback of the application threw: ", written.ToString(), StringComparison.Ordinal);
    }

    // In a fresh copy of the library.
    [Fact]
    public void There_is_no_error_at_first()
    {
        var context = new AssemblyLoadContext(nameof(There_is_no_error_at_first), isCollectible: true);
        Type copy = context.LoadFromAssemblyPath(typeof(NeuronDataReader).Assembly.Location).GetType(typeof(NeuronDataReader).FullName!)!;
        Assert.NotSame(typeof(NeuronDataReader), copy);

        Assert.Equal("No error.", copy.GetMethod("strBRGetLastErrorMessage")!.Invoke(null, null));
        var pointer = (IntPtr)copy.GetMethod("BRGetLastErrorMessage")!.Invoke(null, null)!;
        Assert.Equal("No error.", Marshal.PtrToStringAnsi(pointer));
        context.Unload();
    }

    [Fact]
    public void The_last_error_is_shared_by_threads_and_namespaces()
    {
        using var server = new TestServer();
        using var log = new CallbackLog();
        IntPtr before = NeuronDataReader.BRGetLastErrorMessage();
        Assert.Equal(IntPtr.Zero, log.Connect(0, "127.0.0.1"));
        string error = NeuronDataReader.strBRGetLastErrorMessage();
        Assert.StartsWith("Failed to connect to '127.0.0.1:0'.", error, StringComparison.Ordinal);

        Assert.NotEqual(IntPtr.Zero, log.Connect(server.Port));

        string? elsewhere = null;
        var thread = new Thread(() => elsewhere = Marshal.PtrToStringAnsi(NeuronDataReader.BRGetLastErrorMessage()));
        thread.Start();
        thread.Join();
        Assert.Equal(error, NeuronDataReader.strBRGetLastErrorMessage());
        Assert.Equal(error, elsewhere);
        Assert.Equal(error, NeuronDataReaderManaged.NeuronDataReader.strBRGetLastErrorMessage());
        Assert.Equal(before, NeuronDataReader.BRGetLastErrorMessage());
    }

    [Fact]
    public void A_very_long_error_is_terminated()
    {
        using var log = new CallbackLog();
        string host = new('x', 5000);
        Assert.Equal(IntPtr.Zero, log.Connect(7001, host));
        Assert.Equal(1023, Marshal.PtrToStringAnsi(NeuronDataReader.BRGetLastErrorMessage())!.Length);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void RegisterTemporary(List<long> frames) =>
        NeuronDataReader.BRRegisterFrameDataCallback(51, (customObject, _, _, _) => Add(frames, customObject));

    private static void Add(List<long> list, IntPtr item)
    {
        lock (list)
            list.Add(item.ToInt64());
    }

    private static int Count(List<long> list)
    {
        lock (list)
            return list.Count;
    }

    // Removes all handlers of failures for a while.
    private sealed class Unheard : IDisposable
    {
        private static readonly FieldInfo Field = typeof(CompatibilityEvents).GetField(nameof(CompatibilityEvents.CallbackFailed), BindingFlags.Static | BindingFlags.NonPublic)!;

        private readonly object? _handlers = Field.GetValue(null);

        public Unheard() => Field.SetValue(null, null);

        public void Dispose() => Field.SetValue(null, _handlers);
    }
}
