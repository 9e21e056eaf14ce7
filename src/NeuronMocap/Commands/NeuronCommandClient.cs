using System.Net;
using NeuronMocap.Bvh;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Transport;

namespace NeuronMocap.Commands;

/// <summary>
/// Asks a server for what its stream does not carry, and tells it to zero out avatars: the command channel (manual sections 2.3.9 to 2.3.14,
/// protocol.md section 6), a TCP connection beside that of the stream.
/// <para>
/// Connects when it is first needed, and again whenever that is safer than going on with a connection. All members may be called from any
/// thread; calls are carried out one after the other, in the order in which they were made. Whoever has to may block on the tasks, on any
/// thread, a reader's receive thread included: nothing here needs a thread of the pool. Between calls there is no thread at all.
/// </para>
/// <para>
/// A call ends with the server's answer or with an exception, never with the answer to another: a <see cref="NeuronCommandException"/> for everything that
/// the network and the server do, an <see cref="OperationCanceledException"/> when it is cancelled, at once, wherever it is; an
/// <see cref="ObjectDisposedException"/> when the client is disposed. After each of them but the last the client can be used as before. A
/// command that was cancelled or timed out may have been carried out. A request is sent again, once, where the server closed a connection
/// that was used before without a word.
/// </para>
/// </summary>
public sealed class NeuronCommandClient : IDisposable, IAsyncDisposable
{
    private static readonly TimeSpan StopTimeout = TimeSpan.FromSeconds(2);

    private readonly object _lock = new();
    private readonly NeuronCommandOptions _options;
    private readonly LinkOptions _link;
    private readonly CommandReplies _replies;
    private readonly LinkedList<CommandRequest> _queue = [];
    private Task _working = Task.CompletedTask;
    private CommandRequest? _current;
    private CommandConnection? _connection;
    private bool _isWorking;
    private bool _isDisposed;

    /// <summary>Makes a client that is not connected yet.</summary>
    /// <param name="host">Name or address of the computer that runs Axis Neuron.</param>
    /// <param name="port">TCP port of its command channel.</param>
    /// <exception cref="ArgumentException">The name is empty, or the port is none.</exception>
    public NeuronCommandClient(string host, int port = ProtocolConstants.DefaultCommandPort)
        : this(new NeuronCommandOptions { Host = host, Port = port })
    {
    }

    /// <summary>Makes a client that is not connected yet.</summary>
    /// <param name="options">The settings; copied.</param>
    /// <exception cref="ArgumentException">A setting is out of its range; the message names it.</exception>
    public NeuronCommandClient(NeuronCommandOptions options)
    {
        ArgumentNullException.ThrowIfNull(options);
        if (options.FindFault() is { } fault)
            throw new ArgumentException($"NeuronCommandOptions: {fault}", nameof(options));

        _options = options.Copy();
        _link = _options.Link;
        _replies = new CommandReplies(_link.Target);
    }

    // Replaced by tests: what a resolver does on a machine without a network cannot be foreseen.
    internal Func<string, IPAddress[]> Resolve { get; init; } = Dns.GetHostAddresses;

    // Whether the server has closed the connection that the next command would have gone over. Nobody else looks while none is under way.
    internal bool IsLeft
    {
        get
        {
            lock (_lock)
                return !_isWorking && _connection?.IsLeft == true;
        }
    }

    /// <summary>Connects, unless there is a connection that can be used. Need not be called; it tells early whether there is a server.</summary>
    /// <param name="cancellationToken">Ends the call.</param>
    /// <returns>Ends when there is a connection.</returns>
    /// <exception cref="NeuronCommandException">There is no connection to be had.</exception>
    public Task ConnectAsync(CancellationToken cancellationToken = default) =>
        Enqueue(new CommandRequest<bool>(id: null, avatar: null, static _ => true), cancellationToken);

    /// <summary>
    /// Asks the server to zero out an avatar (manual section 2.3.10). What that changes, the direction, the position or both, is not documented. The
    /// simulator turns the avatar to face front, where it stands.
    /// </summary>
    /// <param name="avatarIndex">Index of the avatar, from 0, as its frames carry it.</param>
    /// <param name="cancellationToken">Ends the call.</param>
    /// <returns>Ends when the server says that it did.</returns>
    /// <exception cref="NeuronCommandException">There is no answer, or the server refused: there is no such avatar.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The index is negative.</exception>
    public Task ZeroOutAsync(int avatarIndex, CancellationToken cancellationToken = default) => Enqueue(
        new CommandRequest<bool>(
            CommandChannelId.ZeroOut, Checked(avatarIndex), payload => _replies.ReadZeroOut(payload, avatarIndex)),
        cancellationToken);

    /// <summary>Asks the server to zero out all avatars (manual section 2.3.11), as <see cref="ZeroOutAsync"/> does for one.</summary>
    /// <param name="cancellationToken">Ends the call.</param>
    /// <returns>Ends when the server says that it did.</returns>
    /// <exception cref="NeuronCommandException">There is no answer, or the server refused.</exception>
    public Task ZeroOutAllAsync(CancellationToken cancellationToken = default) => Enqueue(
        new CommandRequest<bool>(CommandChannelId.ZeroOutAll, avatar: null, payload => _replies.ReadZeroOut(payload, avatar: null)),
        cancellationToken);

    /// <summary>Asks for the order of the rotation values in the server's stream, which an Axis Neuron frame does not carry (manual section 2.3.12).</summary>
    /// <param name="cancellationToken">Ends the call.</param>
    /// <returns>The order, for all avatars.</returns>
    /// <exception cref="NeuronCommandException">There is no answer, or none of the six orders.</exception>
    public Task<RotationOrder> GetRotationOrderAsync(CancellationToken cancellationToken = default) => Enqueue(
        new CommandRequest<RotationOrder>(CommandChannelId.RotationOrder, avatar: null, _replies.ReadRotationOrder), cancellationToken);

    /// <summary>Asks for the sizes of an avatar's body (manual section 2.3.13).</summary>
    /// <param name="avatarIndex">Index of the avatar, from 0, as its frames carry it.</param>
    /// <param name="cancellationToken">Ends the call.</param>
    /// <returns>The sizes, in metres.</returns>
    /// <exception cref="NeuronCommandException">There is no answer, or sizes that no body can have.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The index is negative.</exception>
    public Task<BoneDimensions> GetBoneDimensionsAsync(int avatarIndex, CancellationToken cancellationToken = default) => Enqueue(
        new CommandRequest<BoneDimensions>(
            CommandChannelId.BoneDimensions, Checked(avatarIndex), payload => _replies.ReadDimensions(payload, avatarIndex)),
        cancellationToken);

    /// <summary>Asks for what an avatar's BVH file begins with: its skeleton and the order of its channels (manual section 2.3.14 and Appendix B).</summary>
    /// <param name="avatarIndex">Index of the avatar, from 0, as its frames carry it.</param>
    /// <param name="cancellationToken">Ends the call.</param>
    /// <returns>The header as a document without frames; <see cref="BvhSkeletonMap"/> finds the bones in it.</returns>
    /// <exception cref="NeuronCommandException">There is no answer, or text that is not BVH.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The index is negative.</exception>
    public Task<BvhDocument> GetBvhHeaderAsync(int avatarIndex, CancellationToken cancellationToken = default) =>
        GetHeader(avatarIndex, payload => _replies.ReadHeader(payload, avatarIndex).Document, cancellationToken);

    /// <summary>Asks for the same as <see cref="GetBvhHeaderAsync"/>, as the text that the server sent.</summary>
    /// <param name="avatarIndex">Index of the avatar, from 0, as its frames carry it.</param>
    /// <param name="cancellationToken">Ends the call.</param>
    /// <returns>The text, with the server's line ends.</returns>
    /// <exception cref="NeuronCommandException">There is no answer, or text that is not BVH.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The index is negative.</exception>
    public Task<string> GetBvhHeaderTextAsync(int avatarIndex, CancellationToken cancellationToken = default) =>
        GetHeader(avatarIndex, payload => _replies.ReadHeader(payload, avatarIndex).Text, cancellationToken);

    /// <summary>
    /// Closes the connection and ends all calls that have no answer yet with an <see cref="ObjectDisposedException"/>. Returns within 2 s, and
    /// ordinarily at once; may be repeated, and called from any thread.
    /// </summary>
    public void Dispose() => Stop().Wait(StopTimeout);

    /// <summary>Does what <see cref="Dispose"/> does, without blocking the caller.</summary>
    /// <returns>Ends when all is closed.</returns>
    public async ValueTask DisposeAsync() => await Task.WhenAny(Stop(), Task.Delay(StopTimeout)).ConfigureAwait(false);

    private static int Checked(int avatarIndex) => avatarIndex >= 0
        ? avatarIndex
        : throw new ArgumentOutOfRangeException(nameof(avatarIndex), avatarIndex, "The avatar number must not be negative.");

    private static ObjectDisposedException Disposed() => new(nameof(NeuronCommandClient), "The command client was disposed.");

    private Task<T> GetHeader<T>(int avatarIndex, ReplyParser<T> parse, CancellationToken cancellationToken) =>
        Enqueue(new CommandRequest<T>(CommandChannelId.BvhHeader, Checked(avatarIndex), parse), cancellationToken);

    private Task<T> Enqueue<T>(CommandRequest<T> request, CancellationToken cancellationToken)
    {
        // First, so that whoever ends the request finds the registration. A token that is cancelled already calls back here and now.
        request.Cancellation = cancellationToken.Register(() => Cancel(request, cancellationToken));
        lock (_lock)
        {
            if (_isDisposed)
                request.Fail(Disposed());
            else if (!request.IsCompleted)
                Add(request);
        }

        if (request.IsCompleted)
            request.Cancellation.Dispose();

        return request.Task;
    }

    private void Add(CommandRequest request)
    {
        _queue.AddLast(request);
        if (_isWorking)
            return;

        try
        {
            _working = DedicatedThread.RunAsync("NeuronMocap commands", Work);
            _isWorking = true;
        }
        catch (OutOfMemoryException exception)
        {
            // The system has no thread left.
            _queue.Remove(request);
            request.Fail(exception);
        }
    }

    private void Cancel(CommandRequest request, CancellationToken cancellationToken)
    {
        lock (_lock)
        {
            if (request.Cancel(cancellationToken) && !_queue.Remove(request) && _current == request)
                _connection?.Close();
        }
    }

    private Task Stop()
    {
        lock (_lock)
        {
            _isDisposed = true;
            foreach (CommandRequest request in _queue)
                request.Fail(Disposed());
            _current?.Fail(Disposed());
            _queue.Clear();
            _connection?.Close();
            return _working;
        }
    }

    // The client's thread, for as long as there is something to do.
    private void Work()
    {
        while (TryTake(out CommandRequest? request))
        {
            try
            {
                Carry(request);
            }
            catch (Exception exception)
            {
                // Failures first: whoever sees the call end finds the connection given up.
                Drop();
                request.Fail(exception);
            }

            // Waits for a callback that is under way, and so not under the gate.
            request.Cancellation.Dispose();
        }
    }

    private bool TryTake([System.Diagnostics.CodeAnalysis.NotNullWhen(true)] out CommandRequest? request)
    {
        lock (_lock)
        {
            request = _queue.First?.Value;
            _current = request;
            _isWorking = request is not null;
            if (request is not null)
                _queue.RemoveFirst();

            return _isWorking;
        }
    }

    private void Carry(CommandRequest request)
    {
        CommandConnection? kept = _connection;
        if (kept?.CanAsk(request.Id) == true)
        {
            try
            {
                Ask(kept, request);
                return;
            }
            catch (NeuronCommandException exception) when (exception.Reason == CommandFailure.Closed && !kept.HasHeard && !request.IsCompleted)
            {
                // It was closed in the moment in which it was used: the server had not read the request, or had no wish to.
            }
        }

        CommandConnection connection = Replace(request);
        connection.Open();
        Ask(connection, request);
    }

    private static void Ask(CommandConnection connection, CommandRequest request)
    {
        if (request.Id is null)
            request.Complete(default);
        else
            connection.Ask(request);
    }

    private CommandConnection Replace(CommandRequest request)
    {
        var connection = new CommandConnection(_options, _link, Resolve);
        lock (_lock)
        {
            _connection?.Close();
            _connection = connection;

            // Cancelled or disposed before there was anything to close.
            if (request.IsCompleted)
                connection.Close();
        }

        return connection;
    }

    private void Drop()
    {
        lock (_lock)
            _connection?.Close();
    }
}
