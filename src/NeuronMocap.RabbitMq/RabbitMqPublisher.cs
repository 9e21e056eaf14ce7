using NeuronMocap.RabbitMq.Connecting;
using NeuronMocap.RabbitMq.Publishing;

namespace NeuronMocap.RabbitMq;

/// <summary>
/// Publishes the frames of a reader to a RabbitMQ broker, each packet bit for bit as one message. Sources on any number of computers receive them.
/// </summary>
/// <remarks>
/// <para>
/// The receive thread of the reader only copies each packet. It never waits for the broker. If the broker is slow or gone, the publisher drops frames and
/// counts them; other consumers of the reader are not affected. After a failure, the publisher connects again by itself.
/// </para>
/// <para>
/// Frames that are text lines become binary packets. Their frame index is their number. The reader is the caller's: start it after the publisher. After
/// the reader has stopped, await <see cref="Completion"/>, and then dispose both in any order.
/// </para>
/// </remarks>
public sealed class RabbitMqPublisher : IAsyncDisposable, IDisposable
{
    // Between the receive thread and the outbox, which takes frames as soon as a pool thread runs: 0.7 s of 100 avatars at 60 Hz.
    private const int QueueCapacity = 4096;

    private readonly RabbitMqPublisherOptions _options;
    private readonly FrameQueue _queue;
    private readonly Outbox _outbox;
    private readonly CancellationTokenSource _stopSource = new();
    private readonly object _lock = new();
    private RabbitMqPublisherStatus _status;
    private Task? _running;
    private int _connections;
    private int _started;
    private int _disposed;

    /// <summary>Creates a publisher. It gets every frame that the reader receives from now on.</summary>
    /// <param name="reader">The reader. The publisher does not dispose it.</param>
    /// <param name="options">The broker, the stage, and the stream.</param>
    /// <exception cref="ArgumentException">An option is invalid; the message says which.</exception>
    public RabbitMqPublisher(NeuronReader reader, RabbitMqPublisherOptions options)
    {
        ArgumentNullException.ThrowIfNull(reader);
        ArgumentNullException.ThrowIfNull(options);
        if (options.FindFault() is { } fault)
            throw new ArgumentException(fault, nameof(options));

        _options = options.Copy();
        _outbox = new Outbox(_options, confirms: _options.Stream is not null);
        _status = new RabbitMqPublisherStatus(IsConnected: false, $"The connection to {AmqpAddress.EndPoint(_options)} has not been opened.");
        _queue = reader.OpenQueue(new FrameQueueOptions { Capacity = QueueCapacity, WhenFull = WhenFull.DropOldest, Name = "rabbitmq" });
    }

    /// <summary>Raised after each change of <see cref="Status"/>, on a pool thread. Handlers must return soon. Their exceptions are ignored.</summary>
    public event Action<RabbitMqPublisherStatus>? StatusChanged;

    /// <summary>Whether frames reach the broker, and why not. Thread-safe.</summary>
    public RabbitMqPublisherStatus Status
    {
        get
        {
            lock (_lock)
                return _status;
        }
    }

    /// <summary>
    /// Completes when the reader has stopped and all frames are sent, or <see cref="RabbitMqPublisherOptions.CloseTimeout"/> later, or after
    /// <see cref="DisposeAsync"/>. It fails with a <see cref="NeuronConnectionException"/> if <see cref="RabbitMqPublisherOptions.Reconnect"/> is off and the
    /// connection fails. Before <see cref="StartAsync"/>, it is completed.
    /// </summary>
    public Task Completion => Volatile.Read(ref _running) ?? Task.CompletedTask;

    /// <summary>Takes the counts of this moment. Thread-safe.</summary>
    /// <returns>The counts.</returns>
    public RabbitMqPublisherStatistics GetStatistics() => _outbox.GetStatistics(_queue.Dropped, Volatile.Read(ref _connections));

    /// <summary>Connects to the broker, declares exchange and stream, and begins to publish. Call it once.</summary>
    /// <param name="cancellationToken">Ends the attempt.</param>
    /// <returns>A task that completes when the broker takes frames.</returns>
    /// <exception cref="NeuronConnectionException">The broker is not available, or refuses. The message says why in one sentence.</exception>
    /// <exception cref="InvalidOperationException">The publisher was started or disposed before.</exception>
    /// <exception cref="OperationCanceledException">The attempt was cancelled.</exception>
    public async Task StartAsync(CancellationToken cancellationToken = default)
    {
        var started = new TaskCompletionSource<PublishSession>(TaskCreationOptions.RunContinuationsAsynchronously);
        if (_stopSource.IsCancellationRequested || Interlocked.Exchange(ref _started, 1) != 0)
            throw new InvalidOperationException("The publisher was started or disposed before.");

        Volatile.Write(ref _running, RunAsync(started.Task));
        try
        {
            using var stopSource = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken, _stopSource.Token);
            started.SetResult(await OpenAsync(stopSource.Token).ConfigureAwait(false));
        }
        catch (Exception exception)
        {
            started.SetException(exception);
            SetStatus(isConnected: false, exception.Message);
            throw;
        }
    }

    /// <summary>Ends publishing. Frames that wait are discarded; await <see cref="Completion"/> first to send them. Any number of times.</summary>
    /// <returns>A task that completes when the connection is closed, after a few seconds at most.</returns>
    public async ValueTask DisposeAsync()
    {
        if (Interlocked.Exchange(ref _disposed, 1) == 0)
        {
            _stopSource.Cancel();
            _queue.Dispose();
        }

        // The reason of a failure is in Completion.
        await TaskAbandoning.WaitAsync(Completion, _options.ConnectTimeout + TimeSpan.FromSeconds(5), CancellationToken.None).ConfigureAwait(false);
    }

    /// <summary>Ends publishing as <see cref="DisposeAsync"/> does, and waits for it.</summary>
    public void Dispose() => Task.Run(() => DisposeAsync().AsTask()).GetAwaiter().GetResult();

    private async Task RunAsync(Task<PublishSession> first)
    {
        PublishSession session;
        try
        {
            session = await first.ConfigureAwait(false);
        }
        catch (Exception)
        {
            // The caller of StartAsync gets it.
            return;
        }

        using var endSource = CancellationTokenSource.CreateLinkedTokenSource(_stopSource.Token);
        Task pumping = PumpAsync(endSource);
        try
        {
            await PublishAsync(session, endSource.Token).ConfigureAwait(false);
            SetStatus(isConnected: false, "All frames are sent.");
        }
        catch (OperationCanceledException) when (endSource.IsCancellationRequested)
        {
            SetStatus(isConnected: false, "The publisher has ended.");
        }
        finally
        {
            endSource.Cancel();
            await pumping.ConfigureAwait(false);
        }
    }

    // Takes frames also while there is no connection, so that every one of them gets a number.
    private async Task PumpAsync(CancellationTokenSource endSource)
    {
        Action<Outbox, AvatarFrame> add = static (outbox, frame) => outbox.Add(frame);
        try
        {
            while (await _queue.WaitAsync(endSource.Token).ConfigureAwait(false))
                _queue.Pump(_outbox, add);

            _outbox.Complete();
            endSource.CancelAfter(_options.CloseTimeout);
        }
        catch (Exception exception) when (exception is OperationCanceledException or ObjectDisposedException)
        {
            // The publisher was disposed.
        }
    }

    private async Task PublishAsync(PublishSession session, CancellationToken cancellationToken)
    {
        PublishSession? next = session;
        int failures = 0;
        while (true)
        {
            try
            {
                next ??= await OpenAsync(cancellationToken).ConfigureAwait(false);
                failures = 0;
                await next.RunAsync(cancellationToken).ConfigureAwait(false);
                return;
            }
            catch (NeuronConnectionException exception)
            {
                next = null;
                SetStatus(isConnected: false, exception.Message);
                if (!_options.Reconnect.Enabled)
                    throw;
            }

            await Task.Delay(_options.Reconnect.GetDelay(++failures, jitter: 0), cancellationToken).ConfigureAwait(false);
        }
    }

    private async Task<PublishSession> OpenAsync(CancellationToken cancellationToken)
    {
        PublishSession session = await PublishSession.OpenAsync(_options, _outbox, OnBlocked, cancellationToken).ConfigureAwait(false);
        _outbox.BeginConnection();
        Interlocked.Increment(ref _connections);
        SetStatus(isConnected: true, ConnectedMessage);
        return session;
    }

    private string ConnectedMessage => $"Publishing to {AmqpAddress.EndPoint(_options)}, stage '{_options.Stage}'.";

    private void OnBlocked(string? reason) => SetStatus(isConnected: reason is null, reason ?? ConnectedMessage);

    private void SetStatus(bool isConnected, string message)
    {
        var status = new RabbitMqPublisherStatus(isConnected, message);
        lock (_lock)
        {
            if (_status == status)
                return;

            _status = status;
        }

        try
        {
            StatusChanged?.Invoke(status);
        }
        catch (Exception)
        {
            // A handler that throws must not end publishing, nor leave a connection open.
        }
    }
}
