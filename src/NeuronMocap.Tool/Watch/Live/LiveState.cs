using System.Diagnostics;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Watch.Recordings;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>The data that the live view shows, from its last update. Use it on one thread; other threads may add failures and events.</summary>
internal sealed class LiveState(ConnectionOptions connection)
{
    private static readonly TimeSpan NoticeTime = TimeSpan.FromSeconds(10);

    private readonly Dictionary<int, FootContacts> _contacts = [];
    private readonly SortedDictionary<int, AvatarView> _views = [];
    private readonly RateMeter _bytes = new();
    private readonly RateMeter _allocated = new();
    private readonly long _start = Stopwatch.GetTimestamp();
    private readonly Lock _lock = new();
    private volatile FileFailure[] _failures = [];
    private volatile TimedText? _notice;

    public ConnectionOptions Connection => connection;

    /// <summary>The playback; null for a live stream.</summary>
    public RecordingPlayer? Player { get; init; }

    /// <summary>The recordings of the run; null if recording is impossible.</summary>
    public TakeRecorder? Takes { get; init; }

    /// <summary>Whether a keyboard is available.</summary>
    public bool HasKeyboard { get; init; } = true;

    /// <summary>The files that cannot be written any more: at most a recording and an export. Thread-safe.</summary>
    public IReadOnlyList<FileFailure> FileFailures => _failures;

    /// <summary>The effect of the last key, for some seconds; null for none.</summary>
    public string? Notice => _notice is { } notice && Stopwatch.GetElapsedTime(notice.Timestamp, Now) < NoticeTime ? notice.Text : null;

    public EventLog Events { get; } = new();

    public Counters Counters { get; } = new();

    /// <summary>One scale for all avatars, so that their heights can be compared.</summary>
    public ViewScale Scale { get; private set; } = new();

    public ConnectionStatus Status { get; set; }

    /// <summary>The avatars with motion frames, ordered by their numbers.</summary>
    public IReadOnlyList<AvatarView> Views => [.. _views.Values];

    /// <summary>The avatar in the bone table; null before the first frame.</summary>
    public AvatarView? Selected { get; private set; }

    /// <summary>The newest pose of the selected avatar; null before the first.</summary>
    public Pose? Pose => Selected?.Pose;

    /// <summary>Page of the bone table, or the place after the last page, which shows no table. Any number; it wraps round.</summary>
    public int BonePage { get; set; }

    public bool IsPaused { get; set; }

    /// <summary>Page of the help, from 0; null if the help is hidden.</summary>
    public int? HelpPage { get; set; }

    public long Now { get; private set; } = Stopwatch.GetTimestamp();

    /// <summary>Time of the statistics and poses: <see cref="Now"/>, unless paused.</summary>
    public long TakenAt { get; set; } = Stopwatch.GetTimestamp();

    public TimeSpan Uptime => Stopwatch.GetElapsedTime(_start, Now);

    public double BytesPerSecond => _bytes.PerSecond;

    /// <summary>Bytes that the receive thread allocates per second. Drawing is not included.</summary>
    public double BytesAllocatedByReceiving => _allocated.PerSecond;

    /// <summary>Measures the allocations of the receive thread.</summary>
    public ReceiveAllocations Allocations { get; } = new();

    /// <summary>Updates the state from the reader.</summary>
    public void Update(NeuronReader reader, LatestFrames latest)
    {
        Status = reader.Status;
        Now = Stopwatch.GetTimestamp();
        if (IsPaused)
            return;

        TakenAt = Now;
        ReaderStatistics total = reader.GetStatistics();
        Counters.Take(total, reader.GetAvatarStatistics());
        _bytes.Add(Now, total.BytesReceived);
        _allocated.Add(Now, Allocations.Total);
        foreach (AvatarStatistics avatar in Counters.Avatars.Where(static avatar => (uint)avatar.AvatarIndex < LatestFrames.MaxAvatars))
        {
            if (avatar.Kind == PacketKind.Motion && latest.TryTakeMotion(avatar.AvatarIndex, out MotionFrame? motion))
                Take(motion);
            if (avatar.Kind == PacketKind.Calculation && latest.TryTakeCalculation(avatar.AvatarIndex, out CalculationFrame? frame) && frame.BoneCount > 0)
                _contacts[avatar.AvatarIndex] = frame.FootContacts;
        }
    }

    /// <summary>Takes a frame of any avatar.</summary>
    public void Take(MotionFrame frame)
    {
        int avatar = frame.AvatarIndex;
        if (!_views.TryGetValue(avatar, out AvatarView? view))
            _views.Add(avatar, view = new AvatarView(avatar, frame));

        view.Take(frame);
        Selected ??= view;
        if (view.Pose.HasSkeleton)
            Scale.Include(view.Pose.Points);
    }

    /// <summary>Keeps a failed file in view. Thread-safe.</summary>
    public void AddFailure(FileFailure failure)
    {
        lock (_lock)
            _failures = [.. _failures, failure];

        Events.Add(DateTime.Now, failure);
    }

    /// <summary>Removes a recording that failed or ended, because another one starts.</summary>
    public void ForgetLastRecording()
    {
        _notice = null;
        lock (_lock)
            _failures = [.. _failures.Where(static failure => failure.IsExport)];
    }

    /// <summary>Shows the effect of a key for some seconds, and adds it to the events. Thread-safe.</summary>
    public void Say(string text)
    {
        _notice = new TimedText(text, Stopwatch.GetTimestamp());
        Events.Add(DateTime.Now, text);
    }

    /// <summary>Gets the feet on the ground from a calculation frame of the avatar; null without one.</summary>
    public FootContacts? GetContacts(int avatar) => _contacts.TryGetValue(avatar, out FootContacts contacts) ? contacts : null;

    /// <summary>Gets the feet on the ground: measured if the server sends them, otherwise estimated from the motion.</summary>
    public FootContacts? GetFeet(AvatarView view) => GetContacts(view.Avatar) ?? view.Contacts;

    public void ResetCounters(NeuronReader reader)
    {
        Counters.Reset(reader.GetStatistics(), reader.GetAvatarStatistics());
        Scale = new ViewScale();
    }

    public void SelectNextAvatar()
    {
        AvatarView[] views = [.. _views.Values];
        if (views.Length > 1)
            Selected = views[(Array.IndexOf(views, Selected) + 1) % views.Length];
    }

    private sealed record TimedText(string Text, long Timestamp);
}
