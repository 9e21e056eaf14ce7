namespace NeuronMocap.Diagnostics;

// Judges what arrived: token, version, format, rate.
internal static class StreamExamination
{
    // So many bytes between the frames are no accident of joining in the middle of one.
    private const long FewForeignBytes = 4096;

    private const string NoProblems = "Everything is in order.";

    private const string OrderUnknown = "The stream does not carry the rotation order: set the same order in the program and on the server (default YXZ).";

    private const string OrderKnown = "The stream carries its rotation order, and the reader follows it.";

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
        if (context.Expected == PacketKind.Motion)
            advice += $" To receive these calculation data beside the motion, set CalculationPort to {endpoint.Port}.";

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

        log.Failed("format", $"{sample.Packets} packets without values");
        return new Conclusion(
            DiagnosisVerdict.NoValues, $"Packets arrive on {endpoint}, but none of them carries a pose.", ServerSettings.Play);
    }

    private static void JudgeVersion(StepLog log, AvatarSample avatar, List<ExplainedVerdict> verdicts)
    {
        if (avatar.Version == DataVersion.None)
        {
            log.Warning("version", "none: text, which has no frame index");
            verdicts.Add(new ExplainedVerdict(
                DiagnosisVerdict.TextFormat,
                "Text is read as well as binary packets, but it has no frame index, so that lost frames cannot be counted, few digits, and takes more "
                + "of the network and of both computers.",
                ServerSettings.Binary));
            return;
        }

        if (avatar.Kind == PacketKind.Motion && avatar.Version.Layout == HeaderLayout.Old)
        {
            log.Warning("version", $"{avatar.Version}, the old header, which has no frame index");
            verdicts.Add(new ExplainedVerdict(
                DiagnosisVerdict.OldHeader,
                "The old header (data version 1.0) is read as well as the new one, but it has no frame index: lost frames cannot be counted.",
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
                $"A frame of {StreamPhrases.NameOf(unusual)} carries {unusual.ValueCount} values, where the skeleton of 59 bones has "
                + $"{UsualCounts(unusual.Kind)}.",
                ServerSettings.Skeleton));
        }

        if (sample.BytesSkipped > FewForeignBytes && sample.BytesSkipped > sample.Bytes / 50)
        {
            verdicts.Add(new ExplainedVerdict(
                DiagnosisVerdict.ForeignBytes,
                $"{100 * sample.BytesSkipped / sample.Bytes} % of the bytes that arrive belong to no frame; they are skipped. Frames are cut on the "
                + "way, or another stream is mixed in.",
                "Connect to the server itself, without a program in between, and over UDP let only one program send to the port."));
        }

        int senders = avatars.Select(static avatar => avatar.Sender).Distinct().Count();
        if (senders > 1)
        {
            verdicts.Add(new ExplainedVerdict(
                DiagnosisVerdict.SeveralSenders,
                $"{senders} programs send frames to this port; the reader keeps them apart.",
                "If only one is meant, switch the broadcasting of the others off, or give them another destination port."));
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
