using System.Diagnostics;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Watch.Recordings;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>Everything that the live view shows, as of the last look at the reader. One thread; other threads may add failures and events.</summary>
internal sealed class LiveState(WatchOptions options)
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

    public WatchOptions Options => options;

    /// <summary>What is played instead of a live stream; null for one.</summary>
    public RecordingPlayer? Player { get; init; }

    /// <summary>The recordings of the run; null where none can be made.</summary>
    public TakeRecorder? Takes { get; init; }

    /// <summary>Whether there are keys to press.</summary>
    public bool HasKeyboard { get; init; } = true;

    /// <summary>The files that cannot be written any more, a recording and an export at most. Any thread.</summary>
    public IReadOnlyList<FileFailure> FileFailures => _failures;

    /// <summary>What a key has done, for some seconds; null for nothing.</summary>
    public string? Notice => _notice is { } notice && Stopwatch.GetElapsedTime(notice.Timestamp, Now) < NoticeTime ? notice.Text : null;

    public EventLog Events { get; } = new();

    public Counters Counters { get; } = new();

    /// <summary>One scale for all avatars, so that their heights compare.</summary>
    public ViewScale Scale { get; private set; } = new();

    public ConnectionStatus Status { get; set; }

    /// <summary>The avatars that motion frames came from, by their numbers.</summary>
    public IReadOnlyList<AvatarView> Views => [.. _views.Values];

    /// <summary>The avatar that the table of bones shows; null before there was a frame.</summary>
    public AvatarView? Selected { get; private set; }

    /// <summary>The newest motion frame of the selected avatar; null before there was one.</summary>
    public Pose? Pose => Selected?.Pose;

    /// <summary>Page of the bone table, or the place after the last page, where there is no table. Any number: it goes round.</summary>
    public int BonePage { get; set; }

    public bool IsPaused { get; set; }

    /// <summary>Page of the help, from 0; null when it is not shown.</summary>
    public int? HelpPage { get; set; }

    public long Now { get; private set; } = Stopwatch.GetTimestamp();

    /// <summary>When the figures and the poses were taken: <see cref="Now"/>, unless paused.</summary>
    public long TakenAt { get; set; } = Stopwatch.GetTimestamp();

    public TimeSpan Uptime => Stopwatch.GetElapsedTime(_start, Now);

    public double BytesPerSecond => _bytes.PerSecond;

    /// <summary>Bytes that the receive thread allocates per second. Drawing is not in it.</summary>
    public double BytesAllocatedByReceiving => _allocated.PerSecond;

    /// <summary>Measures what the receive thread allocates.</summary>
    public ReceiveAllocations Allocations { get; } = new();

    /// <summary>Looks at the reader.</summary>
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

    /// <summary>Keeps a file that failed in view. Any thread.</summary>
    public void AddFailure(FileFailure failure)
    {
        lock (_lock)
            _failures = [.. _failures, failure];

        Events.Add(DateTime.Now, failure);
    }

    /// <summary>Forgets a recording that failed or ended, because another one begins.</summary>
    public void ForgetLastRecording()
    {
        _notice = null;
        lock (_lock)
            _failures = [.. _failures.Where(static failure => failure.IsExport)];
    }

    /// <summary>Says for some seconds what a key has done, and keeps it in the events. Any thread.</summary>
    public void Say(string text)
    {
        _notice = new TimedText(text, Stopwatch.GetTimestamp());
        Events.Add(DateTime.Now, text);
    }

    /// <summary>The feet on the ground, where a calculation frame of the avatar said so.</summary>
    public FootContacts? GetContacts(int avatar) => _contacts.TryGetValue(avatar, out FootContacts contacts) ? contacts : null;

    /// <summary>The feet on the ground: measured where the server sends that, or else estimated from the motion.</summary>
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
