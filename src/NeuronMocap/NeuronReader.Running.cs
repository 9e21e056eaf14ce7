using System.Diagnostics;
using NeuronMocap.Reader;
using NeuronMocap.Transport;

namespace NeuronMocap;

/// <content>Start, run and stop, and the actions that a change of the status causes.</content>
public sealed partial class NeuronReader
{
    // The longest time that a timer accepts limits the wait of StartAsync.
    private static readonly TimeSpan LongestWait = TimeSpan.FromDays(24);

    /// <summary>Starts connecting and receiving, and returns at once. If the reader is already started, this does nothing.</summary>
    /// <exception cref="ObjectDisposedException">The reader was disposed.</exception>
    public void Start()
    {
        ObjectDisposedException.ThrowIf(Volatile.Read(ref _disposed) != 0, this);
        if (Interlocked.Exchange(ref _started, 1) != 0)
            return;

        TimeSpan period = TimeSpan.FromSeconds(Math.Min(0.5, _options.SilenceTimeout.TotalSeconds / 4));
        _watchdog = new Watchdog(period, Check, IsIdle);
        if (StartsOnPool || _options.ReceiveThread == ReceiveThread.Pool || !TryRunOnThread("NeuronMocap start", () => _ = RunAsync()))
            _ = Task.Run(RunAsync);
    }

    /// <summary>
    /// Starts the reader and waits for its first connection; for UDP, until the port is bound. It does not wait for frames.
    /// </summary>
    /// <remarks>
    /// If the server is off and reconnecting is on, the wait has no end. To limit it, use <see cref="StartAsync(TimeSpan, CancellationToken)"/> or a
    /// token.
    /// </remarks>
    /// <param name="cancellationToken">Ends the wait; the reader continues to try.</param>
    /// <returns>A task that completes when the connection is established.</returns>
    /// <exception cref="NeuronConnectionException">Reconnecting is off and the connection failed, or the reader was disposed during the wait.</exception>
    /// <exception cref="ObjectDisposedException">The reader was disposed before the call.</exception>
    public Task StartAsync(CancellationToken cancellationToken = default)
    {
        Start();
        return WaitForConnectionAsync(cancellationToken);
    }

    /// <summary>
    /// Starts the reader and waits a limited time for its first connection; for UDP, until the port is bound. It does not wait for frames.
    /// </summary>
    /// <param name="timeout">Longest time to wait; more than zero, at most 24 days. The reader then continues to try; dispose it to give up.</param>
    /// <param name="cancellationToken">Ends the wait; the reader continues to try.</param>
    /// <returns>A task that completes when the connection is established.</returns>
    /// <exception cref="NeuronConnectionException">
    /// There was no connection within this time; the message says why the last attempt failed. Also thrown if reconnecting is off and the connection
    /// failed, or if the reader was disposed during the wait.
    /// </exception>
    /// <exception cref="ArgumentOutOfRangeException">The time is not more than zero, or is more than 24 days.</exception>
    /// <exception cref="ObjectDisposedException">The reader was disposed before the call.</exception>
    public async Task StartAsync(TimeSpan timeout, CancellationToken cancellationToken = default)
    {
        if (timeout <= TimeSpan.Zero || timeout > LongestWait)
            throw new ArgumentOutOfRangeException(nameof(timeout), timeout, "The timeout must be more than zero and at most 24 days.");

        Start();
        using var limitSource = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken);
        limitSource.CancelAfter(timeout);
        try
        {
            await WaitForConnectionAsync(limitSource.Token).ConfigureAwait(false);
        }
        catch (OperationCanceledException)
        {
            cancellationToken.ThrowIfCancellationRequested();
            throw NotConnected(timeout);
        }
    }

    private NeuronConnectionException NotConnected(TimeSpan timeout)
    {
        string current = _status.Current.Message;
        ConnectionStatus last = _status.LastFailure ?? _status.Current with
        {
            Reason = ConnectionReason.TimedOut,
            Message = _options.Source is null ? ConnectionMessages.NotYetAnswered(current) : ConnectionMessages.NotYetOpened(current),
        };
        string message = FormattableString.Invariant($"There was no connection within {timeout.TotalSeconds:0.###} s. The reader continues to try. {last.Message}");
        return new NeuronConnectionException(last.Reason, message, last);
    }

    private async Task WaitForConnectionAsync(CancellationToken cancellationToken)
    {
        var cancelled = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
        using (cancellationToken.Register(() => cancelled.TrySetCanceled(cancellationToken)))
            await (await Task.WhenAny(_connected.Task, cancelled.Task).ConfigureAwait(false)).ConfigureAwait(false);
    }

    /// <summary>
    /// Stops receiving and closes the connection, in any state. After this method returns, normally no handler runs or will run. Any thread, any number of
    /// times.
    /// </summary>
    /// <remarks>
    /// There are two exceptions. When a handler calls this method, the method returns before that handler does, and perhaps before the
    /// connection or port is closed. Await <see cref="Completion"/> before another reader uses the same port. A handler that is still busy
    /// after 2 s is left running. Queues and statistics stay readable.
    /// </remarks>
    public void Dispose()
    {
        // Waits for the two tasks, not for one combined task or Completion. Those need a pool thread, and a busy process may have none for a while.
        Stop();
        if (!IsHandlerThread)
            Task.WaitAll([_stopped.Task, _reporter.Ended], _options.StopTimeout);
    }

    /// <summary>Does the same as <see cref="Dispose"/>, without blocking the thread.</summary>
    /// <returns>A task that completes when the reader has stopped, or after 2 s.</returns>
    public ValueTask DisposeAsync() => StopAsync(keepsMetrics: false);

    // keepsMetrics: the reader reports its last figures until it is disposed. A host stops its readers before its last export of metrics.
    internal async ValueTask StopAsync(bool keepsMetrics)
    {
        Stop(keepsMetrics);
        if (IsHandlerThread)
            return;

        // The code after this await belongs to the caller and must not run on a thread of the reader.
        Task stopped = Task.WhenAll(_stopped.Task, _reporter.Ended).ContinueWith(
            static _ => { }, CancellationToken.None, TaskContinuationOptions.RunContinuationsAsynchronously, TaskScheduler.Default);
        await Task.WhenAny(stopped, Task.Delay(_options.StopTimeout)).ConfigureAwait(false);
    }

    // No barrier is needed: only the thread itself can find its own number here.
    private bool IsHandlerThread
    {
        get
        {
            int thread = Environment.CurrentManagedThreadId;
            return thread == _reportingThread || thread == _pipeline.HandlerThreadNumber || _reporter.IsReporting || _player is { IsPlaybackThread: true };
        }
    }

    // The first part of Dispose; the second part waits for the end.
    internal void Stop(bool keepsMetrics = false)
    {
        if (!keepsMetrics)
            _metrics.Dispose();
        if (Interlocked.Exchange(ref _disposed, 1) == 0)
        {
            _pipeline.Stop();
            _watchdog?.Dispose();
            _discovery?.Stop();
            if (Interlocked.Exchange(ref _started, 1) == 0)
                End();
            else if (!TryRunOnThread("NeuronMocap stop", End))
                End();
        }
    }

    // Runs as many continuations as possible here, down to the handlers of the last status. An end then needs no pool thread, which a busy process may not
    // have for a while. End has its own thread, because those handlers can take longer than a stop.
    private void End()
    {
        _stopSource.Cancel();
        if (Interlocked.Exchange(ref _begun, 1) != 0)
            return;

        // No link will take the stream.
        if (_options.Source is { } source)
            SourceLink.CloseQuietly(source.Discard);

        _ = EndAsync(new ConnectionStatus(ConnectionState.Stopped, ConnectionReason.Requested, LinkEnd.Requested.Message));
    }

    // A busy process may have no pool thread for a while. Returns false if the system has no threads left.
    private static bool TryRunOnThread(string name, Action action)
    {
        try
        {
            _ = DedicatedThread.RunAsync(name, action);
            return true;
        }
        catch (OutOfMemoryException)
        {
            return false;
        }
    }

    private async Task RunAsync()
    {
        // The reader was stopped before this thread began.
        if (Interlocked.Exchange(ref _begun, 1) != 0)
        {
            _watchdog?.Dispose();
            return;
        }

        ConnectionStatus last;
        using var stopSource = CancellationTokenSource.CreateLinkedTokenSource(_stopSource.Token);
        Task<ConnectionStatus> first = _supervisor.RunAsync(_pipeline, _pipeline, _stopSource.Token);
        Task calculation = _calculation?.RunAsync(stopSource.Token) ?? Task.CompletedTask;
        try
        {
            last = await first.ConfigureAwait(false);
        }
        catch (Exception exception)
        {
            // Network errors never arrive here, only errors in the library. They must not make a caller wait forever for the end.
            last = new ConnectionStatus(ConnectionState.Stopped, ConnectionReason.NetworkError, ConnectionMessages.Failed("the server", exception));
        }

        stopSource.Cancel();
        await calculation.ConfigureAwait(false);
        await EndAsync(last).ConfigureAwait(false);
    }

    // Publishes the last report and then the last status, even if the report fails.
    private async Task EndAsync(ConnectionStatus last)
    {
        try
        {
            _watchdog?.Dispose();
            _discovery?.Stop();
            await _recordings.StopAsync().ConfigureAwait(false);
            _discovery?.Dispose();
            await _reporter.EndAsync(Stopwatch.GetTimestamp()).ConfigureAwait(false);
        }
        finally
        {
            _status.Set(last);
        }
    }

    // Time between two checks of a running reader.
    internal TimeSpan CheckPeriod => _watchdog?.Period ?? TimeSpan.Zero;

    private void Check(long now)
    {
        _activity.Check(now);
        _calculation?.Check(now);
        if (_status.Current.IsConnected)
            _discovery?.Check(now);
        if (!_eventHandlers.IsEmpty)
            _reporter.Check(now);
    }

    // Whether only bytes from the network can change anything. The questions of the command channel, refused senders and a second connection need checks.
    private bool IsIdle() => !IsPlayback && _discovery is null && _calculation is null && _options.AllowedSenders.Count == 0 && _activity.IsIdle;

    // Called after the handlers of Stopped, the last status.
    private void Complete(ConnectionStatus last)
    {
        _connected.TrySetException(new NeuronConnectionException(last.Reason, last.Message));
        _ = _connected.Task.Exception; // Observed, because most programs never wait for the connection.
        _pipeline.End();
        _completion.TrySetResult(true);
        _stopped.TrySetResult(true);
    }

    // Called for the first connection only. A change of status on the calculation port is not a new connection, so it causes no questions to the server.
    private void OnFirstStatusChanged(ConnectionStatus status)
    {
        if (status.State == ConnectionState.Connected)
            _discovery?.Begin();

        if (_combinedStatus is null)
            OnStatusChanged(status);
        else
            _combinedStatus.OnFirst(status);
    }

    private void OnStatusChanged(ConnectionStatus status)
    {
        if (status.IsConnected)
            _connected.TrySetResult(true);
        _recordings.Learn(status.Format);
        _watchdog?.Adjust();
        _reportingThread = Environment.CurrentManagedThreadId;
        _reporter.OnStatus(status);
        _statusHandlers.Invoke(status);
        _reportingThread = 0;
        if (status.State == ConnectionState.Stopped)
            Complete(status);
    }

    private void OnFormatLearnt()
    {
        _activity.Redescribe(Stopwatch.GetTimestamp(), isDue: true);
        _recordings.Learn(_format.Discovered.Order, _format.Discovered.Variant);
    }
}
