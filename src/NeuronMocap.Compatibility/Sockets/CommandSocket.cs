using System.Net.Sockets;
using NeuronMocap.Commands;
using NeuronMocap.Compatibility.Callbacks;

namespace NeuronMocap.Compatibility.Sockets;

// A command connection. It calls no callback, and it can be used again after a time-out.
internal sealed class CommandSocket : VendorSocket
{
    private static readonly TimeSpan OpenTimeout = TimeSpan.FromSeconds(5);

    // Includes the time to connect again, and to wait for the calls of other threads.
    private static readonly TimeSpan CallTimeout = TimeSpan.FromSeconds(3);

    private readonly object _owner;
    private readonly string _target;
    private readonly NeuronCommandClient? _client;
    private volatile Task _released = Task.CompletedTask;

    public CommandSocket(object owner, string host, int port)
        : this(owner, host, port, OpenTimeout)
    {
    }

    // connectTimeout: how long the client tries to connect, at most.
    internal CommandSocket(object owner, string host, int port, TimeSpan connectTimeout)
    {
        _owner = owner;
        _target = FormattableString.Invariant($"{host}:{port}");
        try
        {
            _client = new NeuronCommandClient(new NeuronCommandOptions { Host = host, Port = port, ConnectTimeout = connectTimeout });
        }
        catch (ArgumentException)
        {
            // The port number is out of range or the computer name is invalid, so opening fails.
        }
    }

    public override bool IsTo(VendorSocket other) => other is CommandSocket command
        && command._owner == _owner
        && string.Equals(command._target, _target, StringComparison.OrdinalIgnoreCase);

    public override SocketState State => _client?.IsLeft == true ? SocketState.OffWork : base.State;

    // Returns false for everything that is not a correct answer. An impossible answer sets the last error. A server that refuses or does not answer
    // leaves the last error unchanged. Blocks on the client's own task, because a continuation would need a thread of the pool.
    public bool TryCall(Func<NeuronCommandClient, CancellationToken, Task> call)
    {
        if (_client is null || IsClosed)
            return false;

        try
        {
            using var cancelSource = new CancellationTokenSource();
            Task answered = call(_client, cancelSource.Token);
            if (Task.WaitAny([answered], CallTimeout) < 0)
            {
                if (_client.IsConnecting)
                    SetOver();

                cancelSource.Cancel();
            }

            answered.GetAwaiter().GetResult();
            SetOpen();
            return true;
        }
        catch (NeuronCommandException exception)
        {
            // The client connects again at the next request.
            if (exception.Reason is CommandFailure.Closed or CommandFailure.Refused or CommandFailure.NotConnected or CommandFailure.HostNotFound)
                SetOver();
            else if (exception.Reason is CommandFailure.InvalidReply)
                LastError.Set(exception.Message);
        }
        catch (Exception exception) when (exception is ObjectDisposedException or ArgumentOutOfRangeException or OperationCanceledException)
        {
            // The connection was closed meanwhile, the avatar number is invalid, or the time is over.
        }

        return false;
    }

    protected override bool TryOpen()
    {
        if (Connect() is not int error)
        {
            SetOpen();
            return true;
        }

        if (!IsClosed)
            LastError.Set($"Failed to connect to '{_target}'.", error);

        return false;
    }

    // The client's thread may be resolving a name, which cannot be cancelled.
    protected override void BeginRelease() => _released = _client?.DisposeAsync().AsTask() ?? Task.CompletedTask;

    protected override void WaitUntilReleased() => _released.Wait(CloseTimeout);

    private int? Connect()
    {
        if (_client is null)
            return SystemError.InvalidArgument;

        Task connected = _client.ConnectAsync();
        if (Task.WaitAny([connected], OpenTimeout) < 0)
        {
            _client.Dispose();
            return SystemError.CodeOf(ConnectionReason.TimedOut);
        }

        return connected.Exception?.InnerException switch
        {
            null => null,
            NeuronCommandException { Reason: CommandFailure.HostNotFound } => SystemError.CodeOf(ConnectionReason.HostNotFound),
            NeuronCommandException { InnerException: SocketException cause } => cause.ErrorCode,
            _ => SystemError.CodeOf(ConnectionReason.TimedOut),
        };
    }
}
