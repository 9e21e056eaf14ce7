using System.Diagnostics;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.View.Control;
using NeuronMocap.Tool.View.Performers;

namespace NeuronMocap.Tool.View.Live;

/// <summary>The performers of the stream, and what pages must know about them. Thread-safe.</summary>
/// <param name="reader">The reader.</param>
/// <param name="numbers">The numbers in compact poses.</param>
/// <param name="send">Sends a message to every page.</param>
internal sealed class LivePerformers(NeuronReader reader, PerformerNumbers numbers, Action<object> send)
{
    // An actor who pauses for a while stays.
    private static readonly TimeSpan Absence = TimeSpan.FromSeconds(10);

    private readonly Lock _lock = new();
    private readonly SortedDictionary<(int Sender, uint Avatar), LivePerformer> _performers = [];

    /// <summary>Values of the newest motion frame without a skeleton; null if there is none.</summary>
    public int? ValuesWithoutSkeleton { get; private set; }

    /// <summary>The performers, in order.</summary>
    public IReadOnlyList<Performer> List
    {
        get
        {
            lock (_lock)
                return [.. _performers.Values.Select(static performer => performer.Description)];
        }
    }

    /// <summary>Finds a performer; null if there is none with this key.</summary>
    public Performer? Find(PerformerKey key)
    {
        lock (_lock)
            return _performers.GetValueOrDefault(OrderOf(key))?.Description;
    }

    /// <summary>Makes the messages about all performers for a new page.</summary>
    public IEnumerable<object> Greet()
    {
        lock (_lock)
        {
            return
            [
                .. _performers.Values.Select(static performer => new PerformerMessage(performer.Description.ToJson())),
                .. _performers.Values.Select(static performer => ContactMessage.Of(performer)),
            ];
        }
    }

    /// <summary>Takes a frame.</summary>
    public void Take(AvatarFrame frame)
    {
        var key = PerformerKey.Of(frame);
        LivePerformer? performer;
        (bool Description, bool Contacts) changed = default;
        lock (_lock)
        {
            if (frame is CalculationFrame { BoneCount: > 0 } calculation && _performers.GetValueOrDefault(OrderOf(key)) is { } known)
                known.Measured = calculation.FootContacts;
            if (frame is not MotionFrame motion)
                return;

            ValuesWithoutSkeleton = motion.HasSkeleton ? null : motion.Values.Length;
            performer = FindOrAdd(key, motion.AvatarName, out bool isNew);
            if (performer is null)
                return;

            changed = performer.Take(motion, BodyOf(key));
            changed.Description |= isNew;
        }

        if (changed.Description)
            send(new PerformerMessage(performer.Description.ToJson()));
        if (changed.Contacts)
            send(ContactMessage.Of(performer));
    }

    /// <summary>Adds performers whose frames arrive while no page listens, and removes those who have left.</summary>
    public void Update()
    {
        List<object> news = [];
        long now = Stopwatch.GetTimestamp();
        lock (_lock)
        {
            foreach (AvatarStatistics statistics in reader.GetAvatarStatistics().Where(static each => each is { Kind: PacketKind.Motion, Frames: > 0 }))
            {
                var key = PerformerKey.Of(statistics);
                bool isHere = statistics.GetAge(now) < Absence || reader.Status.State != ConnectionState.Receiving;
                if (!isHere && _performers.Remove(OrderOf(key)))
                    news.Add(new GoneMessage(key.ToString()));
                if (isHere && FindOrAdd(key, statistics.AvatarName, out bool isNew) is { } performer && isNew)
                    news.Add(new PerformerMessage(performer.Description.ToJson()));
            }
        }

        news.ForEach(send);
    }

    private static (int Sender, uint Avatar) OrderOf(PerformerKey key) => (key.Sender, (uint)key.Avatar);

    private LivePerformer? FindOrAdd(PerformerKey key, string name, out bool isNew)
    {
        isNew = false;
        if (_performers.TryGetValue(OrderOf(key), out LivePerformer? performer) || numbers.Find(key) is not { } number)
            return performer;

        isNew = true;
        performer = new LivePerformer(key, name, number, BodyOf(key));
        _performers.Add(OrderOf(key), performer);
        return performer;
    }

    // The command channel belongs to one server, which is the first sender.
    private SkeletonBody? BodyOf(PerformerKey key) => key is { Sender: 0, Avatar: >= 0 } && reader.TryGetBody(key.Avatar, out SkeletonBody? body) ? body : null;
}
