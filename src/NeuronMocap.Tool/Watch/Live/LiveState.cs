using System.Diagnostics;
using NeuronMocap.Motion;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Output;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>All that the live view shows, as of the last look at the reader. One thread; only <see cref="Events"/> takes others.</summary>
internal sealed class LiveState(MonitorOptions options)
{
    private readonly Dictionary<int, FootContacts> _contacts = [];
    private readonly FootContactEstimator _feet = new();
    private readonly RateMeter _bytes = new();
    private readonly RateMeter _allocated = new();
    private volatile FileFailure[] _failures = [];
    private readonly long _start = Stopwatch.GetTimestamp();

    public MonitorOptions Options => options;

    /// <summary>What is played instead of a live stream; null for one.</summary>
    public RecordingPlayer? Player { get; init; }

    /// <summary>What records; null when nothing does.</summary>
    public StreamRecorder? Recorder { get; init; }

    /// <summary>The files that cannot be written any more, a recording and an export at most. Any thread.</summary>
    public IReadOnlyList<FileFailure> FileFailures => _failures;

    public EventLog Events { get; } = new();

    public Counters Counters { get; } = new();

    public ViewScale Scale { get; private set; } = new();

    public ConnectionStatus Status { get; set; }

    /// <summary>The newest motion frame of the selected avatar; null before there was one.</summary>
    public Pose? Pose { get; private set; }

    /// <summary>Number of the avatar that is drawn.</summary>
    public int Avatar { get; private set; }

    /// <summary>The feet of the drawn avatar that seem to stand on the ground, by its motion; null before there was a pose.</summary>
    public FootContacts? EstimatedContacts { get; private set; }

    /// <summary>Page of the bone table, counted up without end.</summary>
    public int BonePage { get; set; }

    public bool IsPaused { get; set; }

    public bool ShowsHelp { get; set; }

    public long Now { get; private set; } = Stopwatch.GetTimestamp();

    /// <summary>When the figures and the pose were taken: <see cref="Now"/>, unless paused.</summary>
    public long TakenAt { get; private set; } = Stopwatch.GetTimestamp();

    public TimeSpan Uptime => Stopwatch.GetElapsedTime(_start, Now);

    public double BytesPerSecond => _bytes.PerSecond;

    /// <summary>What the receive thread allocates in a second.</summary>
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
        if (Pose is null && MotionAvatars() is [var first, ..])
            Avatar = first;
        if (latest.TryTakeMotion(Avatar, out MotionFrame? motion))
            Take(motion);

        foreach (AvatarStatistics avatar in Counters.Avatars.Where(avatar => avatar.Kind == PacketKind.Calculation))
        {
            if (latest.TryTakeCalculation(avatar.AvatarIndex, out CalculationFrame? frame) && frame.BoneCount > 0)
                _contacts[avatar.AvatarIndex] = frame.FootContacts;
        }
    }

    /// <summary>Takes a frame of the selected avatar.</summary>
    public void Take(MotionFrame frame)
    {
        if (Pose is null)
            Pose = new Pose(frame);
        else
            Pose.Take(frame);

        if (!Pose.HasSkeleton)
            return;

        Scale.Include(Pose.Points);
        EstimatedContacts = _feet.Update(Pose.World, Pose.Body, frame.Timestamp / (double)Stopwatch.Frequency);
    }

    /// <summary>Keeps a file that failed in view. Any thread, one call at a time.</summary>
    public void AddFailure(FileFailure failure)
    {
        _failures = [.. _failures, failure];
        Events.Add(DateTime.Now, failure);
    }

    /// <summary>The feet on the ground, where a calculation frame of the avatar said so.</summary>
    public FootContacts? GetContacts(int avatar) => _contacts.TryGetValue(avatar, out FootContacts contacts) ? contacts : null;

    public void ResetCounters(NeuronReader reader)
    {
        Counters.Reset(reader.GetStatistics(), reader.GetAvatarStatistics());
        Scale = new ViewScale();
    }

    public void SelectNextAvatar()
    {
        int[] avatars = MotionAvatars();
        if (avatars.Length < 2)
            return;

        Avatar = avatars[(Array.IndexOf(avatars, Avatar) + 1) % avatars.Length];
        Pose = null;
        EstimatedContacts = null;
        _feet.Reset();
        Scale = new ViewScale();
        IsPaused = false;
    }

    private int[] MotionAvatars() => [.. Counters.Avatars
        .Where(avatar => avatar.Kind == PacketKind.Motion && (uint)avatar.AvatarIndex < LatestFrames.MaxAvatars)
        .Select(avatar => avatar.AvatarIndex)
        .Distinct()
        .Order()];
}
