using System.Net.Sockets;
using NeuronMocap.Commands;
using NeuronMocap.Compatibility.Callbacks;
using NeuronMocap.Transport;

namespace NeuronMocap.Compatibility.Sockets;

// A command connection. It calls no callback, and after a time-out it can be used again.
internal sealed class CommandSocket : VendorSocket
{
    private static readonly TimeSpan OpenTimeout = TimeSpan.FromSeconds(5);

    private readonly object _owner;
    private readonly string _target;
    private readonly NeuronCommandClient? _client;

    public CommandSocket(object owner, string host, int port)
    {
        _owner = owner;
        _target = $"{host}:{port}";
        try
        {
            _client = new NeuronCommandClient(new NeuronCommandOptions { Host = host, Port = port, ConnectTimeout = OpenTimeout });
        }
        catch (ArgumentException)
        {
            // No port has that number, or no computer that name: opening fails.
        }
    }

    public override bool IsTo(VendorSocket other) => other is CommandSocket command
        && command._owner == _owner
        && string.Equals(command._target, _target, StringComparison.OrdinalIgnoreCase);

    public override SocketState State => _client?.IsLeft == true ? SocketState.OffWork : base.State;

    // False for everything that is no right answer. Blocks on the client's own task: one that goes on after it would need a thread of the pool.
    public bool TryCall(Func<NeuronCommandClient, Task> call)
    {
        if (_client is null || IsClosed)
            return false;

        try
        {
            call(_client).GetAwaiter().GetResult();
            SetOpen();
            return true;
        }
        catch (NeuronCommandException exception)
        {
            // The client connects again when it is asked the next time.
            if (exception.Reason is CommandFailure.Closed or CommandFailure.Refused or CommandFailure.NotConnected or CommandFailure.HostNotFound)
                SetOver();
        }
        catch (Exception exception) when (exception is ObjectDisposedException or ArgumentOutOfRangeException or OutOfMemoryException)
        {
            // Closed meanwhile, an avatar that cannot be, or no thread left.
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

    protected override void Release() => _client?.Dispose();

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
