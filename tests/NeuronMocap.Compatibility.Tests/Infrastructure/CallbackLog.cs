using System.Runtime.InteropServices;
using NeuronDataReaderWraper;
using NeuronMocap.Compatibility.Sockets;

namespace NeuronMocap.Compatibility.Tests.Infrastructure;

internal sealed record LoggedFrame(IntPtr CustomObject, IntPtr Socket, byte[] Header, float[] Values)
{
    public BvhDataHeader Motion => Read<BvhDataHeader>();

    public CalcDataHeader Calculation => Read<CalcDataHeader>();

    private T Read<T>()
    {
        GCHandle pin = GCHandle.Alloc(Header, GCHandleType.Pinned);
        try
        {
            return Marshal.PtrToStructure<T>(pin.AddrOfPinnedObject())!;
        }
        finally
        {
            pin.Free();
        }
    }
}

internal sealed record LoggedStatus(IntPtr CustomObject, IntPtr Socket, SocketStatus Status, string Text, int Thread, int FramesBefore)
{
    public string Line => $"{(int)Status} {Text}";
}

/// <summary>Registers all callbacks and keeps what they receive. Unregisters and closes at the end.</summary>
internal sealed class CallbackLog : IDisposable
{
    public static readonly IntPtr FrameObject = 11;
    public static readonly IntPtr CalculationObject = 12;
    public static readonly IntPtr StatusObject = 13;
    public static readonly IntPtr CommandObject = 14;

    private static readonly TimeSpan UsualPatience = VendorSocket.CloseTimeout;

    private readonly object _lock = new();
    private readonly List<LoggedFrame> _frames = [];
    private readonly List<LoggedFrame> _calculation = [];
    private readonly List<LoggedStatus> _statuses = [];
    private readonly List<Exception> _failures = [];
    private readonly HashSet<IntPtr> _sockets = [];

    /// <summary>Starts to log.</summary>
    /// <param name="isPatient">Whether closing waits until a running callback ends, instead of the usual short time.</param>
    public CallbackLog(bool isPatient = false)
    {
        VendorSocket.CloseTimeout = isPatient ? Limits.Unexpected : UsualPatience;
        NeuronDataReader.BRRegisterFrameDataCallback(FrameObject, OnFrameData);
        NeuronDataReader.BRRegisterCalculationDataCallback(CalculationObject, OnCalculationData);
        NeuronDataReader.BRRegisterSocketStatusCallback(StatusObject, OnStatusChanged);
        CompatibilityEvents.CallbackFailed += OnFailed;
    }

    /// <summary>Called with the handle, in the callback, after the frame is kept.</summary>
    public Action<IntPtr>? OnFrame { get; set; }

    /// <summary>Called in the callback, after the status is kept.</summary>
    public Action<LoggedStatus>? OnStatus { get; set; }

    public IReadOnlyList<LoggedFrame> Frames => Copy(_frames);

    public IReadOnlyList<LoggedFrame> CalculationFrames => Copy(_calculation);

    public IReadOnlyList<LoggedStatus> Statuses => Copy(_statuses);

    public IReadOnlyList<Exception> Failures => Copy(_failures);

    public IEnumerable<string> LinesOf(IntPtr socket) => Statuses.Where(status => status.Socket == socket).Select(static status => status.Line);

    public IntPtr Connect(int port, string host = "127.0.0.1") => Keep(NeuronDataReader.BRConnectTo(host, port));

    public IntPtr Listen(int port) => Keep(NeuronDataReader.BRStartUDPServiceAt(port));

    public async Task FramesAsync(int count)
    {
        await Limits.UntilAsync(() => Frames.Count >= count || Failures.Count > 0);
        Assert.Empty(Failures);
    }

    public void Dispose()
    {
        VendorSocket.CloseTimeout = UsualPatience;
        foreach (IntPtr socket in _sockets)
            NeuronDataReader.BRCloseSocket(socket);

        NeuronDataReader.BRRegisterFrameDataCallback(IntPtr.Zero, null);
        NeuronDataReader.BRRegisterCalculationDataCallback(IntPtr.Zero, null);
        NeuronDataReader.BRRegisterSocketStatusCallback(IntPtr.Zero, null);
        NeuronDataReader.BRRegisterCommandDataCallback(IntPtr.Zero, null);
        CompatibilityEvents.CallbackFailed -= OnFailed;
    }

    private static LoggedFrame Read(IntPtr customObject, IntPtr socket, IntPtr header, IntPtr data)
    {
        byte[] image = new byte[64];
        Marshal.Copy(header, image, 0, image.Length);
        bool isMotion = image[1] == 0xDD;
        float[] values = new float[isMotion ? BitConverter.ToUInt16(image, 6) : BitConverter.ToInt32(image, 6)];
        Marshal.Copy(data, values, 0, values.Length);
        return new LoggedFrame(customObject, socket, image, values);
    }

    private IntPtr Keep(IntPtr socket)
    {
        if (socket != IntPtr.Zero)
            _sockets.Add(socket);

        return socket;
    }

    private void OnFrameData(IntPtr customObject, IntPtr sockRef, IntPtr header, IntPtr data)
    {
        Add(_frames, Read(customObject, sockRef, header, data));
        OnFrame?.Invoke(sockRef);
    }

    private void OnCalculationData(IntPtr customObject, IntPtr sockRef, IntPtr header, IntPtr data) =>
        Add(_calculation, Read(customObject, sockRef, header, data));

    private void OnStatusChanged(IntPtr customObject, IntPtr sockRef, SocketStatus status, string msg)
    {
        var logged = new LoggedStatus(customObject, sockRef, status, msg, Environment.CurrentManagedThreadId, Frames.Count);
        Add(_statuses, logged);
        OnStatus?.Invoke(logged);
    }

    private void OnFailed(Exception exception) => Add(_failures, exception);

    private void Add<T>(List<T> list, T item)
    {
        lock (_lock)
            list.Add(item);
    }

    private List<T> Copy<T>(List<T> list)
    {
        lock (_lock)
            return [.. list];
    }
}
