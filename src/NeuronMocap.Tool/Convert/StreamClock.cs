using NeuronMocap.Frames;

namespace NeuronMocap.Tool.Convert;

/// <summary>
/// Gives frames of a stream the even times at which the server made them. Arrival times jitter, and frames of a burst arrive together.
/// </summary>
/// <remarks>
/// A frame's number and the rate give its time. A run of numbers begins at the arrival of its first frame: with a connection, when the server
/// restarts its count, or after a pause (<see cref="PauseFinder"/>). Frames without number or rate have their time of arrival.
/// </remarks>
internal sealed class StreamClock(IReadOnlyDictionary<int, StreamAvatar> avatars)
{
    // The frames of all avatars at one moment have the same number and arrive one after the other.
    private static readonly TimeSpan SameMoment = TimeSpan.FromSeconds(0.25);

    private readonly Dictionary<int, Run> _runs = [];
    private Start? _lastStart;

    public TimeSpan TimeOf(AvatarFrame frame, TimeSpan arrival, int connection)
    {
        StreamAvatar avatar = avatars[frame.AvatarIndex];
        if (!avatar.IsNumbered || avatar.Rate is not { } rate || frame.FrameIndex is not { } index)
            return arrival;

        if (!_runs.TryGetValue(frame.AvatarIndex, out Run? run))
            _runs.Add(frame.AvatarIndex, run = new Run(avatar.GetPauses()));

        double perSecond = rate * avatar.Step;
        if (!run.Continues(index, connection, ref arrival))
        {
            // Avatars share the start of a run, so that their times are equal. Times do not go back when another run begins.
            TimeSpan earliest = run.Last is { } last ? last + FrameTimes.Of(1, rate) : TimeSpan.MinValue;
            run.Start = _lastStart is { } shared && shared.Connection == connection && shared.IsNear(index, perSecond, arrival) && shared.TimeOf(index, perSecond) >= earliest
                ? shared
                : new Start(index, arrival > earliest ? arrival : earliest, connection);
            _lastStart = run.Start;
        }

        TimeSpan time = run.Start.TimeOf(index, perSecond);
        run.Last = time;
        return time;
    }

    private readonly record struct Start(uint Index, TimeSpan Time, int Connection)
    {
        public TimeSpan TimeOf(uint index, double perSecond) => Time + FrameTimes.Of((int)(index - Index), perSecond);

        public bool IsNear(uint index, double perSecond, TimeSpan arrival) => (TimeOf(index, perSecond) - arrival).Duration() < SameMoment;
    }

    private sealed class Run(IReadOnlyList<Pause> pauses)
    {
        private readonly IndexTracker _indices = new();
        private int? _connection;
        private long _frames;
        private int _pause;

        public Start Start { get; set; }

        public TimeSpan? Last { get; set; }

        // After a pause, the time is that at which the server sent the frame.
        public bool Continues(uint index, int connection, ref TimeSpan time)
        {
            bool isAfterPause = _pause < pauses.Count && pauses[_pause].Frame == _frames++;
            if (isAfterPause)
                time = pauses[_pause++].Time;

            bool isSame = connection == _connection && !isAfterPause;
            _connection = connection;
            if (!isSame)
                _indices.StartAt(index);

            return isSame && _indices.OnIndex(index) is not IndexChange.Restart;
        }
    }
}
