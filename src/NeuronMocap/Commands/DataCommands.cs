using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Commands;

/// <summary>The commands of the old generation, which share a reader's TCP connection with its frames (protocol.md section 7).</summary>
/// <remarks>
/// <para>
/// Servers around the vendor's b11 and b12 libraries answer them. Newer servers have a separate connection for commands: see
/// <see cref="NeuronCommandClient"/>.
/// </para>
/// <para>
/// A request is sent when you call a method. Replies arrive at any time, between frames. Handle <see cref="Received"/> to get all of them, or await a
/// single value with <see cref="GetAvatarCountAsync"/> and similar methods. All members are thread-safe.
/// </para>
/// </remarks>
public sealed class DataCommands
{
    private static readonly TimeSpan ShortestTimeout = TimeSpan.FromMilliseconds(1);
    private static readonly TimeSpan LongestTimeout = TimeSpan.FromHours(1);

    private readonly TrySend _trySend;
    private readonly HandlerList<DataCommandReply> _handlers;
    private readonly ReplyWaiters _waiters = new();
    private readonly object _lock = new();
    private readonly SortedSet<DataCommandId> _registered = [];
    private readonly Turns _sizes = new();
    private readonly Turns _texts = new();
    private TimeSpan _timeout = TimeSpan.FromSeconds(3);

    internal DataCommands(TrySend trySend, Action<Exception> failed)
    {
        _trySend = trySend;
        _handlers = new HandlerList<DataCommandReply>(failed);
    }

    /// <summary>
    /// Longest time to wait for a reply after a request is sent, in <see cref="GetAvatarCountAsync"/> and similar methods: 1 ms to an hour. The default is
    /// 3 s.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is out of range.</exception>
    public TimeSpan Timeout
    {
        get => _timeout;
        set => _timeout = value >= ShortestTimeout && value <= LongestTimeout
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The timeout must be 1 ms to 1 hour.");
    }

    // Returns false if no connection can carry commands, or if the connection takes no more bytes for a second.
    internal delegate bool TrySend(ReadOnlySpan<byte> bytes);

    /// <summary>
    /// Occurs for every reply, on the receive thread, in the order of arrival. The reader receives nothing while a handler runs.
    /// </summary>
    public event Action<DataCommandReply>? Received
    {
        add => _handlers.Add(value);
        remove => _handlers.Remove(value);
    }

    /// <summary>Requests a value that does not belong to an avatar. <see cref="Received"/> gets the reply.</summary>
    /// <param name="id">The value to request.</param>
    /// <returns>False if the request could not be sent: there is no connection, or frames arrive over UDP.</returns>
    public bool TryRequest(DataCommandId id) => TryRequest(id, avatarIndex: 0);

    /// <summary>Requests a value of an avatar. <see cref="Received"/> gets the reply.</summary>
    /// <param name="id">The value to request.</param>
    /// <param name="avatarIndex">Number of the avatar on the server, from 0.</param>
    /// <returns>False if the request could not be sent: there is no connection, or frames arrive over UDP.</returns>
    public bool TryRequest(DataCommandId id, int avatarIndex) => TrySendRequest(id, avatarIndex);

    /// <summary>
    /// Asks the server to send a value whenever it changes ("auto-sync"). <see cref="Received"/> gets these values. The reader repeats the registration
    /// after every reconnect, until <see cref="TryUnregister"/>.
    /// </summary>
    /// <param name="id">The value to watch.</param>
    /// <returns>False if the request could not be sent; the value is then not registered.</returns>
    public bool TryRegister(DataCommandId id)
    {
        lock (_lock)
        {
            bool sent = TrySendRequest(DataCommandId.RegisterEvent, (int)id);
            if (sent)
                _registered.Add(id);

            return sent;
        }
    }

    /// <summary>Asks the server to stop sending a value when it changes.</summary>
    /// <param name="id">The watched value.</param>
    /// <returns>False if the request could not be sent. The value is not registered again after a reconnect in either case.</returns>
    public bool TryUnregister(DataCommandId id)
    {
        lock (_lock)
        {
            _registered.Remove(id);
            return TrySendRequest(DataCommandId.UnregisterEvent, (int)id);
        }
    }

    /// <summary>Gets the names and lengths of an avatar's bones.</summary>
    /// <remarks>
    /// <para>
    /// Replies do not contain their avatar, so the reader sends these requests one after another. After a reply that did not come in time, the next call
    /// first asks for the number of avatars. A late reply cannot arrive after the reply to that request.
    /// </para>
    /// <para>After <see cref="TryRegister"/>, a change that the server sends without a request can be mistaken for the reply.</para>
    /// </remarks>
    /// <param name="avatarIndex">Number of the avatar on the server, from 0.</param>
    /// <param name="cancellationToken">Ends the wait with an <see cref="OperationCanceledException"/>.</param>
    /// <returns>The bones in the order of the server.</returns>
    /// <exception cref="NeuronCommandException">The request could not be sent, no reply came in time, or the connection ended.</exception>
    public async Task<IReadOnlyList<BoneSize>> GetBoneSizesAsync(int avatarIndex = 0, CancellationToken cancellationToken = default) =>
        (await RequestInTurnAsync(_sizes, DataCommandId.BoneSize, avatarIndex, cancellationToken).ConfigureAwait(false)).BoneSizes!;

    /// <summary>Gets an avatar's hierarchy. <see cref="GetBoneSizesAsync"/> describes how the reader matches a reply to its avatar.</summary>
    /// <param name="avatarIndex">Number of the avatar on the server, from 0.</param>
    /// <param name="cancellationToken">Ends the wait with an <see cref="OperationCanceledException"/>.</param>
    /// <returns>The hierarchy in the text form of a BVH file, as received.</returns>
    /// <exception cref="NeuronCommandException">The request could not be sent, no reply came in time, or the connection ended.</exception>
    public async Task<string> GetBvhTextAsync(int avatarIndex = 0, CancellationToken cancellationToken = default) =>
        (await RequestInTurnAsync(_texts, DataCommandId.BvhText, avatarIndex, cancellationToken).ConfigureAwait(false)).BvhText!;

    /// <summary>Gets the number of avatars on the server.</summary>
    /// <param name="cancellationToken">Ends the wait with an <see cref="OperationCanceledException"/>.</param>
    /// <returns>The number, as received.</returns>
    /// <exception cref="NeuronCommandException">The request could not be sent, no reply came in time, or the connection ended.</exception>
    public async Task<int> GetAvatarCountAsync(CancellationToken cancellationToken = default) =>
        (await RequestAsync(DataCommandId.AvatarCount, avatarIndex: 0, cancellationToken).ConfigureAwait(false)).AvatarCount!.Value;

    /// <summary>Gets an avatar's frame rate. Replies for other avatars are ignored.</summary>
    /// <param name="avatarIndex">Number of the avatar on the server, from 0.</param>
    /// <param name="cancellationToken">Ends the wait with an <see cref="OperationCanceledException"/>.</param>
    /// <returns>Frames per second.</returns>
    /// <exception cref="NeuronCommandException">The request could not be sent, no reply came in time, or the connection ended.</exception>
    public async Task<int> GetFrameRateAsync(int avatarIndex = 0, CancellationToken cancellationToken = default) =>
        (await RequestAsync(DataCommandId.DataFrequency, avatarIndex, cancellationToken).ConfigureAwait(false)).FrameRate!.Value;

    /// <summary>Gets the set of sensors that an avatar wears. Replies for other avatars are ignored.</summary>
    /// <param name="avatarIndex">Number of the avatar on the server, from 0.</param>
    /// <param name="cancellationToken">Ends the wait with an <see cref="OperationCanceledException"/>.</param>
    /// <returns>The mode. Servers can send numbers that the enumeration does not contain.</returns>
    /// <exception cref="NeuronCommandException">The request could not be sent, no reply came in time, or the connection ended.</exception>
    public async Task<CombinationMode> GetCombinationModeAsync(int avatarIndex = 0, CancellationToken cancellationToken = default) =>
        (await RequestAsync(DataCommandId.CombinationMode, avatarIndex, cancellationToken).ConfigureAwait(false)).CombinationMode!.Value;

    // Receive thread.
    internal void OnPacket(in ReceivedPacket packet)
    {
        if (_handlers.IsEmpty && _waiters.IsEmpty)
            return;

        var reply = new DataCommandReply(packet.Bytes);
        _waiters.Complete(reply);
        _handlers.Invoke(reply);
    }

    // A new connection is established; the server knows of no registration yet.
    internal void OnLinkOpened()
    {
        lock (_lock)
        {
            foreach (DataCommandId id in _registered)
                TrySendRequest(DataCommandId.RegisterEvent, (int)id);
        }
    }

    // The connection has ended, so no more replies will arrive.
    internal void OnLinkClosed()
    {
        (_sizes.HasLateReply, _texts.HasLateReply) = (false, false);
        _waiters.FailAll();
    }

    private async Task<DataCommandReply> RequestInTurnAsync(Turns turns, DataCommandId id, int avatarIndex, CancellationToken cancellationToken)
    {
        await turns.Free.WaitAsync(cancellationToken).ConfigureAwait(false);
        try
        {
            if (turns.HasLateReply)
                await RequestAsync(DataCommandId.AvatarCount, avatarIndex: 0, cancellationToken).ConfigureAwait(false);

            DataCommandReply reply = await RequestAsync(id, avatarIndex, cancellationToken, turns).ConfigureAwait(false);
            turns.HasLateReply = false;
            return reply;
        }
        finally
        {
            turns.Free.Release();
        }
    }

    private async Task<DataCommandReply> RequestAsync(DataCommandId id, int avatarIndex, CancellationToken cancellationToken, Turns? turns = null)
    {
        cancellationToken.ThrowIfCancellationRequested();
        ReplyWaiters.Waiter waiter = _waiters.Add(reply => reply.Id == id && (reply.AvatarIndex ?? avatarIndex) == avatarIndex);
        try
        {
            // Before it is sent: the end of the connection, on another thread, resets this.
            if (turns is not null)
                turns.HasLateReply = true;

            if (!TryRequest(id, avatarIndex))
            {
                if (turns is not null)
                    turns.HasLateReply = false;

                throw new NeuronCommandException(
                    CommandFailure.NotConnected,
                    "The command could not be sent, because the reader is not connected over TCP. Start the reader and wait for its connection.");
            }

            using var timeoutSource = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken);
            timeoutSource.CancelAfter(Timeout);
            using (timeoutSource.Token.Register(() => waiter.Reply.TrySetCanceled(timeoutSource.Token)))
                return await waiter.Reply.Task.ConfigureAwait(false);
        }
        catch (OperationCanceledException) when (!cancellationToken.IsCancellationRequested)
        {
            throw new NeuronCommandException(
                CommandFailure.TimedOut,
                $"No reply to the command {id} arrived within {ConnectionMessages.Seconds(Timeout)}. Servers newer than b12 do not accept commands on the data "
                + "connection: use the command port, by default 8013.");
        }
        finally
        {
            _waiters.Remove(waiter);
        }
    }

    private bool TrySendRequest(DataCommandId id, int parameter)
    {
        Span<byte> request = stackalloc byte[ProtocolConstants.HeaderSize];
        new DataCommandHeader { CommandId = id, Parameter = parameter }.Write(request);
        return _trySend(request);
    }

    // For requests whose replies do not contain the avatar: one request at a time. A server answers in the order of the requests.
    private sealed class Turns
    {
        private volatile bool _hasLateReply;

        public SemaphoreSlim Free { get; } = new(1);

        // Whether the reply to an abandoned request may still arrive.
        public bool HasLateReply
        {
            get => _hasLateReply;
            set => _hasLateReply = value;
        }
    }
}
