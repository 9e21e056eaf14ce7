namespace NeuronMocap;

// The statistics of all kinds of frames of one avatar together.
internal readonly record struct AvatarTotals(string Name, double FrameRate, double CalculationRate, long Frames, long Lost)
{
    private static readonly TimeSpan OldestFrame = TimeSpan.FromSeconds(1);

    public AvatarTotals Add(in AvatarStatistics statistics, long now, bool isRunning)
    {
        double rate = isRunning && statistics.GetAge(now) <= OldestFrame ? statistics.FrameRate : 0;
        bool isMotion = statistics.Kind == PacketKind.Motion;
        return new AvatarTotals(
            isMotion || string.IsNullOrEmpty(Name) ? statistics.AvatarName : Name,
            isMotion ? rate : FrameRate,
            isMotion ? CalculationRate : CalculationRate + rate,
            Frames + statistics.Frames,
            Lost + statistics.Lost);
    }
}
