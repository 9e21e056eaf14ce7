using System.Diagnostics;
using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Server.Osc;

/// <summary>
/// A computer and port that datagrams go to, whether or not somebody receives them. One thread sends; the figures can be read on any thread.
/// </summary>
/// <remarks>
/// Sending never waits. If the network or the name fails, it looks the name up again and opens a new socket. It tries after one second,
/// then less and less often. An address needs no look-up, so it is tried once a second. A port that refuses keeps its socket, but a name
/// may then belong to another computer, so it is looked up again too.
/// </remarks>
/// <param name="host">A name or an address.</param>
/// <param name="port">The port.</param>
/// <param name="resolve">Looks a name up.</param>
/// <param name="getTime">Returns the time in ticks of the stopwatch.</param>
/// <param name="createSocket">Creates a socket of an address family; null for the system's.</param>
internal sealed class DatagramTarget(
    string host, int port, Func<string, Task<IPAddress[]>> resolve, Func<long> getTime, Func<AddressFamily, Socket>? createSocket = null) : IDisposable
{
    private static readonly long FirstPause = Stopwatch.Frequency;
    private static readonly long LongestPause = 30 * Stopwatch.Frequency;

    private readonly IPAddress? _literal = IPAddress.TryParse(host, out IPAddress? address) ? address : null;
    private Socket? _socket;
    private IPAddress? _address;
    private Task<IPAddress[]>? _resolving;
    private long _pause = FirstPause;
    private long _nextLook = getTime();
    private bool _looksAgain = true;
    private string? _failure;
    private long _datagrams;
    private long _bytes;
    private long _failed;
    private long _refused;

    /// <summary>Why nothing can be sent at present; null if it can.</summary>
    public string? Failure => Volatile.Read(ref _failure);

    public long Datagrams => Interlocked.Read(ref _datagrams);

    public long Bytes => Interlocked.Read(ref _bytes);

    /// <summary>Number of datagrams that could not be sent.</summary>
    public long Failed => Interlocked.Read(ref _failed);

    /// <summary>How often the other computer said that no program listens on the port.</summary>
    public long Refused => Interlocked.Read(ref _refused);

    /// <summary>Opens the socket, if it is time for that. Call it before each frame.</summary>
    /// <returns>Whether datagrams can be sent.</returns>
    public bool Prepare()
    {
        long now = getTime();
        if (_looksAgain && _resolving is null && now >= _nextLook)
        {
            // What worked for a while starts again with the first pause.
            long pause = now - _nextLook > LongestPause ? FirstPause : _pause;
            _pause = _literal is null ? Math.Min(2 * pause, LongestPause) : FirstPause;
            _nextLook = now + pause;
            _looksAgain = false;
            _resolving = _literal is { } known ? Task.FromResult<IPAddress[]>([known]) : ResolveAsync();
        }

        if (_resolving is { IsCompleted: true } resolved)
        {
            _resolving = null;
            Use(resolved);
        }

        return _socket is not null;
    }

    /// <summary>Sends a datagram, unless the system has no room for it.</summary>
    /// <returns>False if it was not sent.</returns>
    public bool TrySend(byte[] bytes, int length)
    {
        if (_socket is not { } socket)
        {
            Interlocked.Increment(ref _failed);
            return false;
        }

        SocketError error = Send(socket, bytes, length);
        if (error is SocketError.ConnectionRefused or SocketError.ConnectionReset)
        {
            // The error reports that nobody received an earlier datagram, and it keeps this one from being sent. The second attempt sends it.
            Interlocked.Increment(ref _refused);
            _looksAgain |= _literal is null;
            error = Send(socket, bytes, length);
        }

        if (error == SocketError.Success)
        {
            Interlocked.Increment(ref _datagrams);
            Interlocked.Add(ref _bytes, length);
            return true;
        }

        Interlocked.Increment(ref _failed);
        if (error is not (SocketError.WouldBlock or SocketError.NoBufferSpaceAvailable or SocketError.ConnectionRefused or SocketError.ConnectionReset))
            Fail($"nothing can be sent to {host}:{port} ({error})");

        return false;
    }

    public void Dispose() => Close();

    private static SocketError Send(Socket socket, byte[] bytes, int length)
    {
        socket.Send(bytes, 0, length, SocketFlags.None, out SocketError error);
        return error;
    }

    // A name that no computer can have throws at once.
    private async Task<IPAddress[]> ResolveAsync() => await resolve(host).ConfigureAwait(false);

    private void Use(Task<IPAddress[]> resolved)
    {
        if (resolved.Status != TaskStatus.RanToCompletion || resolved.Result.Length == 0)
        {
            // A computer that still receives keeps its address.
            string reason = resolved.Exception?.InnerException is SocketException exception ? exception.SocketErrorCode.ToString() : "no address";
            if (_socket is null)
                Fail($"the host name {host} has no address ({reason})");
            return;
        }

        // IPv4 first, because most receivers bind only to IPv4.
        IPAddress chosen = resolved.Result.OrderBy(static candidate => candidate.AddressFamily != AddressFamily.InterNetwork).First();
        if (_socket is null || !chosen.Equals(_address))
            Open(chosen);
    }

    private void Open(IPAddress chosen)
    {
        Close();
        Socket? socket = null;
        try
        {
            socket = createSocket?.Invoke(chosen.AddressFamily) ?? new Socket(chosen.AddressFamily, SocketType.Dgram, ProtocolType.Udp);
            socket.Blocking = false;
            if (chosen.AddressFamily == AddressFamily.InterNetwork)
                socket.EnableBroadcast = true;
            socket.Connect(new IPEndPoint(chosen, port));
            (_socket, _address) = (socket, chosen);
            Volatile.Write(ref _failure, null);
        }
        catch (SocketException exception)
        {
            socket?.Dispose();
            Fail($"nothing can be sent to {host}:{port} ({exception.SocketErrorCode})");
        }
    }

    private void Fail(string reason)
    {
        Volatile.Write(ref _failure, reason);
        _looksAgain = true;
        Close();
    }

    private void Close()
    {
        _socket?.Dispose();
        _socket = null;
    }
}
