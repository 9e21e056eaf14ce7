using NeuronMocap.Protocol;

namespace NeuronMocap.Diagnostics;

// Judges the received data: token, version, format, rate.
internal static class StreamExamination
{
    // More bytes than this between frames are not explained by joining the stream in the middle of a frame.
    private const long FewForeignBytes = 4096;

    private const string NoProblems = "Everything is in order.";

    private const string OrderUnknown = "The stream does not contain the rotation order: set the same order in the program and on the server (default YXZ).";

    private const string OrderKnown = "The stream contains its rotation order, and the reader uses it.";

    public static Conclusion Judge(DiagnosisContext context, StreamSample sample, StreamEndpoint endpoint)
    {
        if (sample.Has(context.Expected))
            return JudgeFrames(context, sample, endpoint);
        if (sample.Avatars.Any())
            return JudgeOtherKind(context, sample, endpoint);
        if (sample.Packets > 0)
            return JudgeEmpty(context.Log, sample, endpoint);

        return ForeignBytes.Judge(context.Log, sample, endpoint);
    }

    private static Conclusion JudgeFrames(DiagnosisContext context, StreamSample sample, StreamEndpoint endpoint)
    {
        var verdicts = new List<ExplainedVerdict>();
        AvatarSample[] avatars = [.. sample.Avatars.Where(avatar => avatar.Kind == context.Expected)];
        context.Log.Ok("token", DescribeTokens(sample));
        JudgeVersion(context.Log, avatars[0], verdicts);
        JudgeFormat(context.Log, sample, avatars, verdicts);
        RateExamination.Judge(context.Log, avatars, endpoint.Transport == TransportKind.Udp, verdicts);

        string summary = $"Frames arrive on {endpoint}: {StreamPhrases.Describe(avatars)}.";
        if (verdicts.Count == 0)
        {
            return new Conclusion([new ExplainedVerdict(DiagnosisVerdict.Receiving, $"{summary} {NoProblems} {(avatars[0].Version == DataVersion.Studio ? OrderKnown : OrderUnknown)}")], sample, endpoint);
        }

        verdicts.Sort(static (left, right) => right.Verdict.CompareTo(left.Verdict));
        verdicts[0] = verdicts[0] with { Text = $"{summary} {verdicts[0].Text}" };
        return new Conclusion(verdicts, sample, endpoint);
    }

    private static Conclusion JudgeOtherKind(DiagnosisContext context, StreamSample sample, StreamEndpoint endpoint)
    {
        context.Log.Failed("token", $"{DescribeTokens(sample)} only");
        DiagnosisVerdict verdict = (sample.Has(PacketKind.Motion), sample.Has(PacketKind.Calculation)) switch
        {
            (true, _) => DiagnosisVerdict.MotionOnly,
            (_, true) => DiagnosisVerdict.CalculationOnly,
            _ => DiagnosisVerdict.StudioCalculationOnly,
        };
        string text = $"Frames arrive on {endpoint}, but they are {StreamPhrases.KindsOf(sample)}; none are {StreamPhrases.NameOf(context.Expected)}.";
        string advice = ServerSettings.Enable(context.Expected);
        if (context.Expected == PacketKind.Motion && endpoint.Source is null)
            advice += $" To receive this calculation data in addition to motion, set CalculationPort to {endpoint.Port}.";

        return new Conclusion([new ExplainedVerdict(verdict, text, advice)], sample);
    }

    private static Conclusion JudgeEmpty(StepLog log, StreamSample sample, StreamEndpoint endpoint)
    {
        if (sample.Commands > 0)
        {
            log.Failed("token", "0xAAFF: commands, no data");
            return new Conclusion(
                DiagnosisVerdict.CommandPort,
                $"{Capital(endpoint)} sends commands, not frames.",
                ServerSettings.DataPort);
        }

        log.Failed("format", $"{CountedNoun.Of(sample.Packets, "packet")} without values");
        return new Conclusion(
            DiagnosisVerdict.NoValues, $"Packets arrive on {endpoint}, but none of them contains a pose.", ServerSettings.Play);
    }

    private static void JudgeVersion(StepLog log, AvatarSample avatar, List<ExplainedVerdict> verdicts)
    {
        if (avatar.Version == DataVersion.None)
        {
            log.Warning("version", "none: text, which has no frame index");
            verdicts.Add(new ExplainedVerdict(
                DiagnosisVerdict.TextFormat,
                "The reader supports text as well as binary packets. Text has few digits and no frame index, so lost frames cannot be counted. It also needs more "
                + "of the network and of both computers.",
                ServerSettings.Binary));
            return;
        }

        if (avatar.Kind == PacketKind.Motion && avatar.Version.Layout == HeaderLayout.Old)
        {
            log.Warning("version", $"{avatar.Version}, the old header, which has no frame index");
            verdicts.Add(new ExplainedVerdict(
                DiagnosisVerdict.OldHeader,
                "The reader supports the old header (data version 1.0) as well as the new one. It has no frame index, so lost frames cannot be counted.",
                ServerSettings.NewHeader));
            return;
        }

        log.Ok("version", $"{avatar.Version}{StreamPhrases.ProducerOf(avatar)}");
    }

    private static void JudgeFormat(StepLog log, StreamSample sample, AvatarSample[] avatars, List<ExplainedVerdict> verdicts)
    {
        int before = verdicts.Count;
        if (avatars.FirstOrDefault(avatar => !IsUsual(avatar)) is { } unusual)
        {
            verdicts.Add(new ExplainedVerdict(
                DiagnosisVerdict.UnusualValueCount,
                $"A frame of {StreamPhrases.NameOf(unusual)} has {CountedNoun.Of(unusual.ValueCount, "value")}; the skeleton of 59 bones has "
                + $"{UsualCounts(unusual.Kind)}.",
                ServerSettings.Skeleton));
        }

        if (sample.BytesSkipped > FewForeignBytes && sample.BytesSkipped > sample.Bytes / 50)
        {
            verdicts.Add(new ExplainedVerdict(
                DiagnosisVerdict.ForeignBytes,
                $"{100 * sample.BytesSkipped / sample.Bytes} % of the bytes that arrive belong to no frame; they are skipped. Frames are damaged on the "
                + "way, or another stream is mixed in.",
                "Connect to the server directly, without a program in between. Over UDP, let only one program send to the port."));
        }

        int senders = avatars.Select(static avatar => avatar.Sender).Distinct().Count();
        if (senders > 1)
        {
            verdicts.Add(new ExplainedVerdict(
                DiagnosisVerdict.SeveralSenders,
                $"{senders} programs send frames to this port; the reader separates them.",
                "If you want only one, switch off the broadcasting of the others, or give them another destination port."));
        }

        string detail = $"{StreamPhrases.DescribeFormat(avatars[0])}; {StreamPhrases.DescribeAvatars(avatars)}";
        if (verdicts.Count > before)
            log.Warning("format", detail);
        else
            log.Ok("format", detail);
    }

    private static bool IsUsual(AvatarSample avatar) => avatar.Kind switch
    {
        PacketKind.Motion => avatar.ValueCount is 180 or 186 or 354 or 360,
        PacketKind.Calculation => avatar.ValueCount is 338 or 946,
        _ => avatar.ValueCount == 1239,
    };

    private static string UsualCounts(PacketKind kind) => kind switch
    {
        PacketKind.Motion => "180, 186, 354 or 360",
        PacketKind.Calculation => "338 or 946",
        _ => "1239",
    };

    private static string DescribeTokens(StreamSample sample)
    {
        (PacketKind Kind, string Token)[] tokens =
            [(PacketKind.Motion, "0xDDFF"), (PacketKind.Calculation, "0x88FF"), (PacketKind.StudioCalculation, "0xDCCF")];
        string kinds = StreamPhrases.KindsOf(sample);
        return sample.IsText
            ? $"lines of text: {kinds}"
            : $"{string.Join(" and ", tokens.Where(token => sample.Has(token.Kind)).Select(static token => token.Token))}: {kinds}";
    }

    private static string Capital(StreamEndpoint endpoint)
    {
        string text = endpoint.ToString();
        return char.ToUpperInvariant(text[0]) + text[1..];
    }
}
