using System.Diagnostics;
using System.Net;
using NeuronMocap.Server.Osc;

namespace NeuronMocap.Server;

/// <summary>
/// Sends the poses that a reader receives to another program, over OSC and UDP. The base of <see cref="VmcSender"/> and <see cref="OscSender"/>.
/// </summary>
/// <remarks>
/// <para>
/// The newest frame of each avatar wins: a frame is not sent if a newer one is there. A receiver that is off costs nothing and does not end the sender.
/// After a failure of the network, the host name is looked up again.
/// </para>
/// <para>All members are thread-safe. A pool thread sends; it runs only while frames arrive. The receive thread never waits.</para>
/// </remarks>
public abstract class PoseSender : IDisposable, IAsyncDisposable
{
    // The newest frame of each avatar is kept outside of the queue. The queue holds what arrives while the system does not run the thread.
    private const int QueueCapacity = 256;
    private const string QueueName = "poses";

    private readonly object _lock = new();
    private readonly TaskCompletionSource<bool> _completion = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly NeuronReader _reader;
    private readonly OscSettings _settings;
    private readonly AvatarPoses _poses;
    private readonly IPoseEncoder _encoder;
    private readonly OscBundle _bundle;
    private readonly DatagramTarget _target;

    private FrameQueue? _queue;
    private bool _isWhole;
    private bool _isDisposed;
    private long _lost;
    private long _rejected;
    private long _sent;
    private long _dropped;
    private long _ignored;

    private protected PoseSender(NeuronReader reader, OscSettings settings, AvatarPoses poses, IPoseEncoder encoder)
    {
        _reader = reader;
        _settings = settings;
        _poses = poses;
        _encoder = encoder;
        _bundle = new OscBundle(settings.MaxDatagramSize, (bytes, length) => _isWhole &= _target!.TrySend(bytes, length));
        _target = new DatagramTarget(settings.Host, settings.Port, Dns.GetHostAddressesAsync, Stopwatch.GetTimestamp);
    }

    /// <summary>Completes when the reader has stopped and everything is sent, or when the sender is disposed. Faults only because of a defect.</summary>
    public Task Completion => _completion.Task;

    /// <summary>Starts to send what the reader receives from now on. To send the first frame too, start the sender before the reader.</summary>
    /// <exception cref="InvalidOperationException">The sender has already been started.</exception>
    /// <exception cref="ObjectDisposedException">The sender has been disposed.</exception>
    public void Start()
    {
        lock (_lock)
        {
            if (_isDisposed)
                throw new ObjectDisposedException(nameof(PoseSender), "The sender has been disposed.");
            if (_queue is not null)
                throw new InvalidOperationException("The sender has already been started.");

            _queue = _reader.OpenMotionQueue(new FrameQueueOptions
            {
                Capacity = QueueCapacity,
                Name = QueueName,
                WhenFull = WhenFull.DropOldest,
                MaxRate = _settings.MaxRate,
            });
        }

        _ = Task.Run(() => RunAsync(_queue));
    }

    /// <summary>Gets the figures of this moment.</summary>
    /// <returns>A snapshot. While the sender runs, single figures may differ by a frame.</returns>
    public PoseSenderStatistics GetStatistics() => new()
    {
        FramesSent = Interlocked.Read(ref _sent),
        FramesDropped = Interlocked.Read(ref _dropped) + (_queue?.Dropped ?? 0),
        FramesIgnored = Interlocked.Read(ref _ignored),
        FramesSkipped = _queue?.Skipped ?? 0,
        DatagramsSent = _target.Datagrams,
        DatagramsFailed = _target.Failed,
        BytesSent = _target.Bytes,
        Refusals = _target.Refused,
        Failure = _target.Failure,
    };

    /// <summary>Ends the sender. The last datagram may go out a moment later. Can be called repeatedly.</summary>
    public void Dispose()
    {
        lock (_lock)
        {
            if (_isDisposed)
                return;

            _isDisposed = true;
            if (_queue is null)
                Finish(failure: null);
            else
                _queue.Dispose();
        }

        GC.SuppressFinalize(this);
    }

    /// <summary>Ends the sender, as <see cref="Dispose"/> does, and waits until the last datagram is sent.</summary>
    /// <returns>A task that completes when everything is closed.</returns>
    public async ValueTask DisposeAsync()
    {
        Dispose();
        GC.SuppressFinalize(this);
        await Task.WhenAny(_completion.Task).ConfigureAwait(false);
    }

    private async Task RunAsync(FrameQueue queue)
    {
        Exception? failure = null;
        try
        {
            // A name is looked up while no frame has arrived yet.
            _target.Prepare();
            while (await queue.WaitAsync().ConfigureAwait(false))
            {
                queue.Pump<MotionFrame, AvatarPoses>(_poses, static (poses, frame) => poses.Take(frame), QueueCapacity);
                SendPending();
            }
        }
        catch (Exception exception)
        {
            failure = exception;
        }

        queue.Dispose();
        Finish(failure);
    }

    private void SendPending()
    {
        bool isReady = _target.Prepare();
        for (int i = 0; i < _poses.All.Count; i++)
        {
            AvatarPose pose = _poses.All[i];
            if (!pose.IsPending)
                continue;

            pose.IsPending = false;
            _isWhole = isReady;
            if (isReady && !_encoder.TryEncode(pose, _bundle))
                _rejected++;
            else if (_isWhole)
                Interlocked.Increment(ref _sent);
            else
                _lost++;
        }

        Interlocked.Exchange(ref _ignored, _poses.Ignored + _rejected);
        Interlocked.Exchange(ref _dropped, _poses.Replaced + _lost);
    }

    private void Finish(Exception? failure)
    {
        _target.Dispose();
        if (failure is null)
            _completion.TrySetResult(true);
        else
            _completion.TrySetException(failure);
    }
}
