namespace NeuronMocap.Tool.Watch.Live;

/// <summary>The statistics of the reader since the last reset.</summary>
internal sealed class Counters
{
    private readonly Dictionary<(PacketKind Kind, int Source, int Avatar), AvatarStatistics> _atReset = [];
    private ReaderStatistics _totalAtReset;

    public ReaderStatistics Total { get; private set; }

    public IReadOnlyList<AvatarStatistics> Avatars { get; private set; } = [];

    public void Take(ReaderStatistics total, IReadOnlyList<AvatarStatistics> avatars)
    {
        Total = total with
        {
            MotionFrames = total.MotionFrames - _totalAtReset.MotionFrames,
            CalculationFrames = total.CalculationFrames - _totalAtReset.CalculationFrames,
            Lost = total.Lost - _totalAtReset.Lost,
            Gaps = total.Gaps - _totalAtReset.Gaps,
            Restarts = total.Restarts - _totalAtReset.Restarts,
            Dropped = total.Dropped - _totalAtReset.Dropped,
            BytesSkipped = total.BytesSkipped - _totalAtReset.BytesSkipped,
            RejectedMessages = total.RejectedMessages - _totalAtReset.RejectedMessages,
        };
        Avatars = [.. avatars.Select(Since)];
    }

    public void Reset(ReaderStatistics total, IReadOnlyList<AvatarStatistics> avatars)
    {
        _totalAtReset = total;
        foreach (AvatarStatistics avatar in avatars)
            _atReset[KeyOf(avatar)] = avatar;

        Take(total, avatars);
    }

    private static (PacketKind Kind, int Source, int Avatar) KeyOf(AvatarStatistics avatar) =>
        (avatar.Kind, avatar.Sender, avatar.AvatarIndex);

    private AvatarStatistics Since(AvatarStatistics now)
    {
        AvatarStatistics then = _atReset.GetValueOrDefault(KeyOf(now));
        return now with
        {
            Frames = now.Frames - then.Frames,
            Lost = now.Lost - then.Lost,
            Gaps = now.Gaps - then.Gaps,
            OutOfOrder = now.OutOfOrder - then.OutOfOrder,
            Restarts = now.Restarts - then.Restarts,
        };
    }
}
