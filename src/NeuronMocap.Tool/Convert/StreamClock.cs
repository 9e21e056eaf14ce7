using NeuronMocap.Frames;

namespace NeuronMocap.Tool.Convert;

/// <summary>
/// Gives frames of a stream the even times at which the server made them. Arrival times jitter, and frames of a burst arrive together.
/// </summary>
/// <remarks>
/// A frame's number and the rate give its time. A run of numbers begins with a connection, when the server restarts its count, or after a pause
/// (<see cref="PauseFinder"/>). The time between two runs is that between their arrivals, or the length of the pause. Frames without number or
/// rate have their time of arrival.
/// </remarks>
internal sealed class StreamClock(IReadOnlyDictionary<(int Sender, int Avatar), StreamAvatar> avatars)
{
    // The frames of all avatars at one moment have the same number and arrive one after the other.
    private static readonly TimeSpan SameMoment = TimeSpan.FromSeconds(0.25);

    private readonly Dictionary<StreamAvatar, Run> _runs = [];
    private Start? _lastStart;

    // How far the last frame is from its arrival, because the clock of the server differs from the usual rate.
    private TimeSpan _drift;

    public TimeSpan TimeOf(AvatarFrame frame, TimeSpan arrival, int connection)
    {
        StreamAvatar avatar = avatars[(frame.Sender, frame.AvatarIndex)];
        if (!avatar.IsNumbered || avatar.Rate is not { } rate || frame.FrameIndex is not { } index)
            return arrival;

        if (!_runs.TryGetValue(avatar, out Run? run))
            _runs.Add(avatar, run = new Run(avatar.GetPauses()));

        double perSecond = rate * avatar.Step;
        if (!run.Continues(index, connection, out TimeSpan? pause))
        {
            // Avatars share the start of a run, so that their times are equal. Times do not go back when another run begins.
            TimeSpan earliest = run.Last is { } last ? last + FrameTimes.Of(1, rate) : TimeSpan.MinValue;
            TimeSpan begin = pause is { } length ? run.Start.TimeOf(index, perSecond) + length : arrival + _drift;
            bool isShared = _lastStart is { } shared && shared.Connection == connection && shared.TimeOf(index, perSecond) >= earliest
                && (shared.IsNear(index, perSecond, begin) || (run.Last is null && shared.IsNear(index, perSecond, arrival)));
            run.Start = isShared
                ? _lastStart!.Value
                : new Start(index, begin > earliest ? begin : earliest, connection);
            _lastStart = run.Start;
        }

        TimeSpan time = run.Start.TimeOf(index, perSecond);
        run.Last = time;
        _drift = time - arrival;
        return time;
    }

    private readonly record struct Start(uint Index, TimeSpan Time, int Connection)
    {
        public TimeSpan TimeOf(uint index, double perSecond) => Time + FrameTimes.Of((int)(index - Index), perSecond);

        public bool IsNear(uint index, double perSecond, TimeSpan time) => (TimeOf(index, perSecond) - time).Duration() < SameMoment;
    }

    private sealed class Run(IReadOnlyList<Pause> pauses)
    {
        private readonly IndexTracker _indices = new();
        private int? _connection;
        private long _frames;
        private int _pause;

        public Start Start { get; set; }

        public TimeSpan? Last { get; set; }

        // The pause is that before the frame; null if there is none.
        public bool Continues(uint index, int connection, out TimeSpan? pause)
        {
            pause = _pause < pauses.Count && pauses[_pause].Frame == _frames++ ? pauses[_pause++].Length : null;
            bool isSame = connection == _connection && pause is null;
            _connection = connection;
            if (!isSame)
                _indices.StartAt(index);

            return isSame && _indices.OnIndex(index) is not IndexChange.Restart;
        }
    }
}
