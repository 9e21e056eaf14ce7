using NeuronMocap.Protocol;

namespace NeuronMocap.Diagnostics;

// Judges the frame rate against the rates at which suits measure.
internal static class RateExamination
{
    // A tenth below 60 Hz, the slowest rate of a suit.
    private const double LowestRate = 54;

    private static readonly int[] SuitRates = [60, 96, 120];

    public static void Judge(StepLog log, AvatarSample[] avatars, bool isUdp, List<ExplainedVerdict> verdicts)
    {
        int before = verdicts.Count;
        AvatarSample slowest = avatars.OrderBy(static avatar => avatar.FrameRate).First();
        JudgeLoss(avatars, isUdp, verdicts);
        if (avatars.FirstOrDefault(static avatar => avatar.IsMotionless) is { } still)
        {
            verdicts.Add(new ExplainedVerdict(
                DiagnosisVerdict.Motionless,
                $"All frames of {StreamPhrases.NameOf(still)} are the same.",
                "Unless someone stands still on purpose, the take is paused or at its end, or the suit is disconnected. Check the server's window."));
        }

        if (slowest.FrameRate < LowestRate)
            verdicts.Add(LowRate(slowest));

        string detail = Describe(avatars, slowest);
        if (verdicts.Count > before)
            log.Warning("rate", detail);
        else
            log.Ok("rate", detail);
    }

    private static void JudgeLoss(AvatarSample[] avatars, bool isUdp, List<ExplainedVerdict> verdicts)
    {
        long lost = avatars.Sum(static avatar => avatar.Lost);
        long all = lost + avatars.Sum(static avatar => avatar.Frames);
        if (lost * 100 <= all)
            return;

        verdicts.Add(new ExplainedVerdict(
            DiagnosisVerdict.LosingFrames,
            $"{lost} of {all} frames did not arrive.",
            isUdp
                ? "UDP loses datagrams when a network or computer is too busy. Use a cable instead of Wi-Fi, raise the system's limit if the step \"buffer\" "
                    + "warns, or choose TCP here and on the server."
                : "TCP itself loses nothing: the server leaves frames out. Close other programs on its computer, and use a cable instead of Wi-Fi "
                    + "between suit and computer."));
    }

    private static ExplainedVerdict LowRate(AvatarSample avatar)
    {
        if (avatar.FrameRate <= 0)
            return new ExplainedVerdict(DiagnosisVerdict.LowRate, $"Only {CountedNoun.Of(avatar.Frames, "frame")} arrived during the diagnosis.", ServerSettings.FullRate);

        string reason = avatar.Step > 1
            ? $"the server sends one frame in {avatar.Step}"
            : Fraction(avatar.FrameRate) is { } fraction ? $"the server seems to send {fraction}" : "a suit measures 60, 96 or 120 times a second";
        return new ExplainedVerdict(
            DiagnosisVerdict.LowRate,
            FormattableString.Invariant($"{avatar.FrameRate:0.0} frames per second is too few: {reason}."),
            ServerSettings.FullRate);
    }

    // Returns a text if the rate is half or a third of a suit's rate; otherwise null.
    private static string? Fraction(double rate)
    {
        for (int divisor = 2; divisor <= 3; divisor++)
        {
            foreach (int suit in SuitRates)
            {
                if (Math.Abs((rate * divisor) - suit) < suit * 0.03)
                    return $"one frame in {divisor} of {suit}";
            }
        }

        return null;
    }

    private static string Describe(AvatarSample[] avatars, AvatarSample slowest)
    {
        if (slowest.FrameRate <= 0)
            return $"{CountedNoun.Of(slowest.Frames, "frame")}, too few to measure";

        long lost = avatars.Sum(static avatar => avatar.Lost);
        double pause = avatars.Max(static avatar => avatar.LongestGap.TotalMilliseconds);
        return FormattableString.Invariant($"{slowest.FrameRate:0.0} Hz, {(lost > 0 ? $"{CountedNoun.Of(lost, "frame")} lost" : "none lost")}, longest pause {pause:0} ms");
    }
}
