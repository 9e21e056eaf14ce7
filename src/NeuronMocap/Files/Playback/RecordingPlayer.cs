using NeuronMocap.Frames;
using NeuronMocap.Skeleton;
using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

/// <summary>
/// Plays a recording, or a raw dump of the bytes of a stream, to a <see cref="NeuronReader"/> as if the data arrived from the network now.
/// Thread-safe.
/// </summary>
/// <remarks>
/// <para>
/// The first bytes of the file determine its kind. The same bytes are processed in the same pieces. Frames, statistics and states are therefore
/// those of the reader that recorded; see docs/guide/playback.md.
/// </para>
/// <para>
/// Open a player, create a reader with <see cref="NeuronReader(RecordingPlayer, NeuronReaderOptions?)"/>, and start the reader. The player belongs
/// to that reader, which does not dispose it. All members may also be called from handlers of the reader. They do not wait for the playback: a
/// change applies from the next piece on. A handler that is running may still process the previous piece.
/// </para>
/// <para>
/// At a finite speed, each piece is delivered at its time. <see cref="AvatarFrame.Timestamp"/> is that instant, even if a handler delayed the
/// playback. A delay of more than a second also delays everything that follows.
/// </para>
/// <para>
/// At <see cref="MaxSpeed"/>, pieces follow each other without a wait. Timestamps then advance as recorded, ahead of the clock, and rates are those
/// of the recording. Timestamps never decrease.
/// </para>
/// </remarks>
public sealed class RecordingPlayer : IDisposable
{
    /// <summary>The <see cref="Speed"/> that plays as fast as handlers and queues allow.</summary>
    public const double MaxSpeed = double.PositiveInfinity;

    /// <summary>The value of <see cref="Passes"/> that repeats the recording without end.</summary>
    public const int Endless = PlaybackControl.Endless;

    // There must be time left to play.
    private static readonly TimeSpan LastPosition = TimeSpan.FromTicks(RecordingLayout.MaxTime);

    private readonly RecordedEventSource _source;
    private readonly PlaybackFile _file;
    private readonly PlaybackControl _control;
    private PlaybackRun? _run;
    private int _readers;
    private volatile bool _waitsForQueues = true;
    private volatile bool _isPaced = true;
    private volatile bool _isClosed;

    internal RecordingPlayer(RecordedEventSource source, PlaybackOptions options, PlaybackTime? time = null)
    {
        _source = source;
        _file = new PlaybackFile(source);
        _control = new PlaybackControl(time ?? (options.Clock is { } clock ? new ManualTime(clock) : PlaybackTime.Real), source.Duration);
        Options = options;
        if (options.Clock is { } moved)
            moved.Moved += _control.FollowClock;
    }

    /// <summary>
    /// Occurs when the last pass has ended, on the playback's thread, before the reader's status changes. A handler can dispose the player and the reader.
    /// </summary>
    public event Action? Completed;

    /// <summary>Name of the file, without its folder.</summary>
    public string FileName => _source.FileName;

    /// <summary>Duration of one pass at speed 1.</summary>
    public TimeSpan Duration => _source.Duration;

    /// <summary>The position in the recording, from zero to <see cref="Duration"/>. Use <see cref="Seek"/> to change it.</summary>
    public TimeSpan Position => _control.Position;

    /// <summary>
    /// The speed relative to the recording: 0.01 to 100, or <see cref="MaxSpeed"/>. The default is 1. It can be changed during playback.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is out of range.</exception>
    public double Speed
    {
        get => _control.Speed;
        set
        {
            if (value is not ((>= 0.01 and <= 100) or MaxSpeed))
                throw new ArgumentOutOfRangeException(nameof(value), value, "The speed must be 0.01 to 100, or MaxSpeed.");

            _control.Speed = value;
            _isPaced = !double.IsPositiveInfinity(value);
        }
    }

    /// <summary>
    /// The number of times that the recording is played: 1 or more, or <see cref="Endless"/>. The default is 1. It can be changed during playback.
    /// Each pass begins with a new connection.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is less than 1.</exception>
    public int Passes
    {
        get => _control.Passes;
        set
        {
            if (value < 1)
                throw new ArgumentOutOfRangeException(nameof(value), value, "The number of passes must be at least 1.");

            _control.Passes = value;
        }
    }

    /// <summary>The number of the current pass, from 1.</summary>
    public int Pass => _control.Pass;

    /// <summary>Whether the playback is paused.</summary>
    public bool IsPaused => _control.IsPaused;

    /// <summary>
    /// Whether the playback at <see cref="MaxSpeed"/> waits for full queues, so that consumers receive all frames. The default is true.
    /// </summary>
    /// <remarks>
    /// A queue that is never emptied then stops the playback: dispose such a queue. If false, and at any other speed, frames that do not fit into a
    /// queue are dropped and counted, as with a live stream. This option does not change queues with <see cref="WhenFull.Wait"/>, which the playback
    /// always waits for.
    /// </remarks>
    public bool WaitForQueues
    {
        get => _waitsForQueues;
        set => _waitsForQueues = value;
    }

    // Whether the time without frames says nothing about the recording.
    internal bool IsHeld => IsPaused || Options.Clock is not null;

    // Whether the playback's thread calls this.
    internal bool IsPlaybackThread => _run is { IsCaller: true };

    // The name in status messages.
    internal string Target => _file.Target;

    internal PlaybackOptions Options { get; }

    /// <summary>Opens a file.</summary>
    /// <param name="path">
    /// The path of a recording (<c>.nmrec</c>), or of the received bytes of a stream. The first bytes determine the kind of the file, not its name.
    /// </param>
    /// <param name="options">The options; null to use the values of the file.</param>
    /// <returns>A player at the start of the recording. It does nothing until its reader is started.</returns>
    /// <exception cref="PlaybackException">The file is neither a recording nor a dump of a stream.</exception>
    /// <exception cref="NeuronException">The file is a recording that cannot be read.</exception>
    /// <exception cref="IOException">The file cannot be opened or read, or is a pipe.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to read the file.</exception>
    /// <exception cref="ArgumentException">An option is out of range, or has no meaning for this file.</exception>
    public static RecordingPlayer Open(string path, PlaybackOptions? options = null)
    {
        PlaybackOptions copy = PlaybackOptions.CopyChecked(options);
        return new RecordingPlayer(RecordedEventSource.Open(path, copy), copy);
    }

    /// <summary>Pauses before the next piece. It can be called before the reader is started. Further calls have no effect.</summary>
    public void Pause() => _control.Pause();

    /// <summary>Continues after a pause.</summary>
    public void Resume() => _control.Resume();

    /// <summary>
    /// Pauses, and delivers the next frame of any avatar. Each further call delivers one more frame. At the end of the recording, this has no
    /// effect. Over UDP, the smallest step is a datagram, which may contain several frames.
    /// </summary>
    public void Step() => _control.Step();

    /// <summary>
    /// Pauses, and delivers the frame before the last delivered one; at the start, the first frame again. For the reader, this is a jump like
    /// <see cref="Seek"/>.
    /// </summary>
    public void StepBack() => _control.StepBack();

    /// <summary>
    /// Moves to another position, in either direction, paused or not.
    /// </summary>
    /// <remarks>
    /// <para>
    /// Parsers start again. The data before the position is read silently to find where a packet begins. The first delivered frame is the first one
    /// whose last byte was recorded at that time or later.
    /// </para>
    /// <para>
    /// The statistics of the reader continue and count one more reconnect. Frames between the positions do not count as lost. Over UDP, senders
    /// receive new numbers.
    /// </para>
    /// </remarks>
    /// <param name="position">
    /// The time since the start. A value outside the recording means its start or end. For motion that never ends, the end is a position after about 3,650
    /// years.
    /// </param>
    public void Seek(TimeSpan position)
    {
        TimeSpan last = Duration < LastPosition ? Duration : LastPosition;
        _control.Seek(position < TimeSpan.Zero ? TimeSpan.Zero : position < last ? position : last);
    }

    /// <summary>
    /// Waits until all frames that are due have been delivered, for example after <see cref="ManualClock.MoveTo"/>. Handlers have then returned.
    /// </summary>
    /// <remarks>
    /// It returns at once while no reader plays the file, while the playback is paused, and at <see cref="MaxSpeed"/>. Do not call it from a handler of
    /// the reader. It does not allocate memory.
    /// </remarks>
    /// <param name="timeout">The longest wait, zero or more. <see cref="Timeout.InfiniteTimeSpan"/> means no limit.</param>
    /// <returns>False if the time was not enough.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The timeout is negative and not infinite.</exception>
    public bool WaitUntilDelivered(TimeSpan timeout)
    {
        if (timeout < TimeSpan.Zero && timeout != Timeout.InfiniteTimeSpan)
            throw new ArgumentOutOfRangeException(nameof(timeout), timeout, "The timeout must be zero or more, or infinite.");

        return _control.WaitUntilDelivered(timeout);
    }

    /// <summary>
    /// Closes the file. If the reader is running, it stops within milliseconds, even while the playback waits. A full queue that the playback waits for
    /// then drops the frame and counts it.
    /// </summary>
    public void Dispose()
    {
        _isClosed = true;
        _file.Close();
        _control.End();
        if (Options.Clock is { } clock)
            clock.Moved -= _control.FollowClock;
    }

    // Called once. Returns the factory of the reader's links.
    internal Func<Link> Attach(SenderFilter filter, Action<Exception> callbackFailed)
    {
        ObjectDisposedException.ThrowIf(_file.IsClosed, this);
        if (Interlocked.Exchange(ref _readers, 1) != 0)
            throw new InvalidOperationException("The player already has a reader; open the file again for another reader.");

        var feed = new PlaybackFeed(_source, filter, Options.MaxValues ?? _source.MaxValues);
        var run = new PlaybackRun(_file, _control, feed, () => Complete(callbackFailed));
        _run = run;
        return () => new PlaybackLink(run);
    }

    // Whether the receive path may wait for a full queue.
    internal bool MayWait(WhenFull whenFull) => !_isClosed && (whenFull == WhenFull.Wait || (_waitsForQueues && !_isPaced));

    internal FrameFormat CreateFormat(RotationOrder? order, SkeletonVariant? variant) =>
        _source.CreateFormat(order ?? Options.RotationOrder, variant ?? Options.SkeletonVariant);

    // Playback thread.
    private void Complete(Action<Exception> callbackFailed)
    {
        try
        {
            Completed?.Invoke();
        }
        catch (Exception exception)
        {
            callbackFailed(exception);
        }
    }
}
