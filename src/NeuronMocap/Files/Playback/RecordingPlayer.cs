using NeuronMocap.Frames;
using NeuronMocap.Skeleton;
using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

/// <summary>
/// Plays what a file holds of a stream to a <see cref="NeuronReader"/>, as if it arrived from the network now: a recording, or a raw dump of a stream's
/// bytes, whichever the file's first bytes say it is. The same bytes go the same way in the same pieces, so that the reader's frames, statistics
/// and states are those of the reader that recorded; see docs/guide/playback.md.
/// <para>
/// Open one, make a reader with <see cref="NeuronReader(RecordingPlayer, NeuronReaderOptions?)"/>, start it. The player belongs to that reader, which does
/// not dispose of it. All members may be called from any thread, from handlers of the reader too, and none waits for the playback: a
/// change counts from the next piece on, and a handler that runs meanwhile may still be at the one before.
/// </para>
/// <para>
/// At a speed, each piece is handed out at its time: <see cref="AvatarFrame.Timestamp"/> is that instant, also where a handler
/// held the playback up. What is late by more than a second puts off what follows. At <see cref="MaxSpeed"/> pieces follow each other without a wait and timestamps count on as recorded, ahead of
/// the clock, so that rates are those of the recording. Timestamps never go back.
/// </para>
/// </summary>
public sealed class RecordingPlayer : IDisposable
{
    /// <summary>The <see cref="Speed"/> that means: as fast as handlers and queues take it.</summary>
    public const double MaxSpeed = double.PositiveInfinity;

    /// <summary>The <see cref="Passes"/> that means: again and again, without end.</summary>
    public const int Endless = PlaybackControl.Endless;

    private readonly RecordedEventSource _source;
    private readonly PlaybackFile _file;
    private readonly PlaybackControl _control;
    private int _readers;
    private volatile bool _waitsForQueues = true;
    private volatile bool _isPaced = true;

    internal RecordingPlayer(RecordedEventSource source, PlaybackOptions options, PlaybackTime? time = null)
    {
        _source = source;
        _file = new PlaybackFile(source);
        _control = new PlaybackControl(time ?? PlaybackTime.Real, source.Duration);
        Options = options;
    }

    /// <summary>Called when the last pass is over, on the playback's thread, before the reader's status says so.</summary>
    public event Action? Completed;

    /// <summary>Name of the file, without its folder.</summary>
    public string FileName => _source.FileName;

    /// <summary>How long one pass takes at speed 1.</summary>
    public TimeSpan Duration => _source.Duration;

    /// <summary>Where the playback stands in the recording, from zero to <see cref="Duration"/>. To change it: <see cref="Seek"/>.</summary>
    public TimeSpan Position => _control.Position;

    /// <summary>How many times as fast as it was recorded: 0.01 to 100, or <see cref="MaxSpeed"/>. 1 unless set; also while it plays.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is outside its range.</exception>
    public double Speed
    {
        get => _control.Speed;
        set
        {
            if (value is not ((>= 0.01 and <= 100) or MaxSpeed))
                throw new ArgumentOutOfRangeException(nameof(value), value, "The speed is 0.01 to 100, or MaxSpeed.");

            _control.Speed = value;
            _isPaced = !double.IsPositiveInfinity(value);
        }
    }

    /// <summary>
    /// How many times the recording is played in all, 1 or more, or <see cref="Endless"/>. 1 unless set; also while it plays. Each pass begins with a
    /// new connection.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is less than 1.</exception>
    public int Passes
    {
        get => _control.Passes;
        set
        {
            if (value < 1)
                throw new ArgumentOutOfRangeException(nameof(value), value, "A recording is played once at least.");

            _control.Passes = value;
        }
    }

    /// <summary>Which pass it is, from 1.</summary>
    public int Pass => _control.Pass;

    /// <summary>Whether the playback is paused.</summary>
    public bool IsPaused => _control.IsPaused;

    /// <summary>
    /// Whether at <see cref="MaxSpeed"/> the playback waits for queues that are full, so that whoever pumps one, or awaits frames, gets them all. True unless set.
    /// A queue that nobody pumps then stops the playback: dispose of it. Without, and at any other speed, frames that find a queue full are
    /// dropped and counted, as those of a live stream.
    /// </summary>
    public bool WaitForQueues
    {
        get => _waitsForQueues;
        set => _waitsForQueues = value;
    }

    // What status messages call it.
    internal string Target => _file.Target;

    internal PlaybackOptions Options { get; }

    /// <summary>Opens a file.</summary>
    /// <param name="path">A recording (<c>.nmrec</c>), or the bytes of a stream as they came off the wire. Which one it is, its first bytes tell, not its name.</param>
    /// <param name="options">How to read it; null for what the file says.</param>
    /// <returns>A player that stands at the start and does nothing until its reader is started.</returns>
    /// <exception cref="PlaybackException">The file is neither.</exception>
    /// <exception cref="NeuronException">It is a recording that cannot be read.</exception>
    /// <exception cref="IOException">The file cannot be opened or read.</exception>
    /// <exception cref="UnauthorizedAccessException">The file may not be read.</exception>
    /// <exception cref="ArgumentException">An option is out of its range, or has no meaning for this file.</exception>
    public static RecordingPlayer Open(string path, PlaybackOptions? options = null)
    {
        PlaybackOptions copy = PlaybackOptions.CopyChecked(options);
        return new RecordingPlayer(RecordedEventSource.Open(path, copy), copy);
    }

    /// <summary>Stops before the next piece; also before the reader is started. Pausing again does nothing.</summary>
    public void Pause() => _control.Pause();

    /// <summary>Goes on from where it was paused.</summary>
    public void Resume() => _control.Resume();

    /// <summary>
    /// Pauses, and hands out the next frame of any avatar. Several calls hand out several. At the end of the recording nothing happens. Over UDP the
    /// smallest step is a datagram, which may hold several frames.
    /// </summary>
    public void Step() => _control.Step();

    /// <summary>
    /// Pauses, goes back and hands out the frame before the one that was handed out last; at the start, the first one again. For the reader that is a
    /// jump, as <see cref="Seek"/> is.
    /// </summary>
    public void StepBack() => _control.StepBack();

    /// <summary>
    /// Goes on at another place, in either direction, paused or not. Parsers begin anew: what precedes the place is read silently to find where a packet begins, and the first
    /// frame is the first whose last byte was recorded at that time or later. The reader's statistics go on, with a reconnect more, and no frame counts as lost
    /// between the places. Over UDP, senders are numbered anew.
    /// </summary>
    /// <param name="position">Time since the start; what lies outside the recording is its start or end.</param>
    public void Seek(TimeSpan position) =>
        _control.Seek(position < TimeSpan.Zero ? TimeSpan.Zero : position < Duration ? position : Duration);

    /// <summary>Closes the file. The reader stops, if it has not; within milliseconds, whatever the playback waits for.</summary>
    public void Dispose()
    {
        _file.Close();
        _control.End();
    }

    // Once: returns what makes the reader's links.
    internal Func<Link> Attach(SenderFilter filter, Action<Exception> callbackFailed)
    {
        ObjectDisposedException.ThrowIf(_file.IsClosed, this);
        if (Interlocked.Exchange(ref _readers, 1) != 0)
            throw new InvalidOperationException("The player has a reader; open the file once for each.");

        var feed = new PlaybackFeed(_source, filter, Options.MaxValues ?? _source.MaxValues);
        var run = new PlaybackRun(_file, _control, feed, () => Complete(callbackFailed));
        return () => new PlaybackLink(run);
    }

    // Whether the receive path may wait for queues.
    internal Func<bool> BackPressure => () => _waitsForQueues && !_isPaced;

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
