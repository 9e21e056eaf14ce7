using System.Diagnostics;
using NeuronMocap.Transport;

namespace NeuronMocap;

/// <content>Start, run and stop, and what each change of the status sets off.</content>
public sealed partial class NeuronReader
{
    // Of a StartAsync: what timers can take.
    private static readonly TimeSpan LongestWait = TimeSpan.FromDays(24);

    /// <summary>Starts connecting and receiving, and returns at once. Starting again does nothing.</summary>
    /// <exception cref="ObjectDisposedException">The reader was disposed of.</exception>
    public void Start()
    {
        ObjectDisposedException.ThrowIf(Volatile.Read(ref _disposed) != 0, this);
        if (Interlocked.Exchange(ref _started, 1) != 0)
            return;

        TimeSpan period = TimeSpan.FromSeconds(Math.Min(0.5, _options.SilenceTimeout.TotalSeconds / 4));
        _watchdog = new Timer(_ => Check(Stopwatch.GetTimestamp()), state: null, period, period);
        if (StartsOnPool || _options.ReceiveThread == ReceiveThread.Pool || !TryRunOnThread())
            _ = Task.Run(RunAsync);
    }

    /// <summary>
    /// Starts the reader and waits for its first connection; for UDP, for the port. It does not wait for frames. Where the server is off and reconnecting is
    /// on, the wait has no end: give it a time with <see cref="StartAsync(TimeSpan, CancellationToken)"/>, or a token.
    /// </summary>
    /// <param name="cancellationToken">Ends the wait; the reader goes on trying.</param>
    /// <returns>A task that completes when the connection stands.</returns>
    /// <exception cref="NeuronConnectionException">Reconnecting is off and there is no connection, or the reader was disposed of meanwhile.</exception>
    /// <exception cref="ObjectDisposedException">The reader was disposed of before.</exception>
    public Task StartAsync(CancellationToken cancellationToken = default)
    {
        Start();
        return WaitForConnectionAsync(cancellationToken);
    }

    /// <summary>Starts the reader and waits some time for its first connection; for UDP, for the port. It does not wait for frames.</summary>
    /// <param name="timeout">Longest time to wait; more than zero. The reader goes on trying after it: dispose of it to give up.</param>
    /// <param name="cancellationToken">Ends the wait; the reader goes on trying.</param>
    /// <returns>A task that completes when the connection stands.</returns>
    /// <exception cref="NeuronConnectionException">
    /// There was no connection in this time; the message says what the last attempt failed of. Or reconnecting is off and there is no connection, or the
    /// reader was disposed of meanwhile.
    /// </exception>
    /// <exception cref="ArgumentOutOfRangeException">The time is not more than zero, or more than 24 days.</exception>
    /// <exception cref="ObjectDisposedException">The reader was disposed of before.</exception>
    public async Task StartAsync(TimeSpan timeout, CancellationToken cancellationToken = default)
    {
        if (timeout <= TimeSpan.Zero || timeout > LongestWait)
            throw new ArgumentOutOfRangeException(nameof(timeout), timeout, "The time to wait is more than zero and at most 24 days.");

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
        ConnectionStatus last = _status.LastFailure ?? _status.Current with { Reason = ConnectionReason.TimedOut, Message = ConnectionMessages.NotYetAnswered(_status.Current.Message) };
        string message = FormattableString.Invariant($"There was no connection within {timeout.TotalSeconds:0.###} s. The reader goes on trying. {last.Message}");
        return new NeuronConnectionException(last.Reason, message, last);
    }

    private async Task WaitForConnectionAsync(CancellationToken cancellationToken)
    {
        var cancelled = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
        using (cancellationToken.Register(() => cancelled.TrySetCanceled(cancellationToken)))
            await (await Task.WhenAny(_connected.Task, cancelled.Task).ConfigureAwait(false)).ConfigureAwait(false);
    }

    /// <summary>
    /// Stops receiving and closes the connection, in whatever state it is. When it returns, no handler runs and none will, with two
    /// exceptions: called from a handler it returns before that handler does, and a handler that is still busy after 2 s is left behind.
    /// Any thread, any number of times. Queues and statistics stay readable.
    /// </summary>
    public void Dispose()
    {
        // Not for both in one task, nor for Completion: that would take a thread of the pool, and in a busy process there may be none for a while.
        Stop();
        if (!IsHandlerThread)
            Task.WaitAll([_stopped.Task, _reporter.Ended], _options.StopTimeout);
    }

    /// <summary>As <see cref="Dispose"/>, without blocking the thread.</summary>
    /// <returns>A task that completes when the reader has stopped, or after 2 s.</returns>
    public ValueTask DisposeAsync() => StopAsync(keepsMetrics: false);

    // With its metrics kept, a reader reports its last figures until it is disposed of: a host stops its readers before it exports for the last time.
    internal async ValueTask StopAsync(bool keepsMetrics)
    {
        Stop(keepsMetrics);
        if (IsHandlerThread)
            return;

        // What follows is the caller's, and not for a thread of the reader.
        Task stopped = Task.WhenAll(_stopped.Task, _reporter.Ended).ContinueWith(
            static _ => { }, CancellationToken.None, TaskContinuationOptions.RunContinuationsAsynchronously, TaskScheduler.Default);
        await Task.WhenAny(stopped, Task.Delay(_options.StopTimeout)).ConfigureAwait(false);
    }

    // Only the thread itself can find its own number here, so no barrier is needed.
    private bool IsHandlerThread
    {
        get
        {
            int thread = Environment.CurrentManagedThreadId;
            return thread == _reportingThread || thread == _pipeline.DeliveringThread || _reporter.IsReporting;
        }
    }

    // What Dispose begins with, and then waits for.
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
            else
                _ = DedicatedThread.RunAsync("NeuronMocap stop", End);
        }
    }

    // What waits goes on in here as far as it can, down to the handlers of the last status, so that no end needs a pool thread: in a busy process
    // there may be none for a while. On a thread of its own, because those handlers may take longer than a stop.
    private void End()
    {
        _stopSource.Cancel();
        if (Interlocked.Exchange(ref _begun, 1) == 0)
            _ = EndAsync(new ConnectionStatus(ConnectionState.Stopped, ConnectionReason.Requested, LinkEnd.Requested.Message));
    }

    // In a busy process the pool may have no thread for a while. False where the system has no more threads to give.
    private bool TryRunOnThread()
    {
        try
        {
            _ = DedicatedThread.RunAsync("NeuronMocap start", () => _ = RunAsync());
            return true;
        }
        catch (OutOfMemoryException)
        {
            return false;
        }
    }

    private async Task RunAsync()
    {
        // Stopped before a thread had time for the start.
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
            // Nothing the network does comes here; whoever waits for the end shall not wait for ever because of a fault of ours.
            last = new ConnectionStatus(ConnectionState.Stopped, ConnectionReason.NetworkError, ConnectionMessages.Failed("the server", exception));
        }

        stopSource.Cancel();
        await calculation.ConfigureAwait(false);
        await EndAsync(last).ConfigureAwait(false);
    }

    // The last report, then the last status, whatever becomes of the report.
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

    private void Check(long now)
    {
        _activity.Check(now);
        _calculation?.Check(now);
        if (_status.Current.IsConnected)
            _discovery?.Check(now);
        if (!_eventHandlers.IsEmpty)
            _reporter.Check(now);
    }

    // When the handlers of Stopped, the last status, have run.
    private void Complete(ConnectionStatus last)
    {
        _connected.TrySetException(new NeuronConnectionException(last.Reason, last.Message));
        _ = _connected.Task.Exception; // observed: most programs never wait for the connection
        _pipeline.End();
        _completion.TrySetResult(true);
        _stopped.TrySetResult(true);
    }

    // Of the first connection alone: what the calculation port does to the status is no new connection to ask questions about.
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
