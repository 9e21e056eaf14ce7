using NeuronMocap.Protocol;
using NeuronMocap.Server.Faults;

namespace NeuronMocap.Server;

// Checks the ranges that the documentation of the options states. The messages name the setting.
internal static class BroadcasterOptionsCheck
{
    private const int MaxAvatars = 256;

    public static void Check(BroadcasterOptions options)
    {
        if (options.Reader is not null)
            CheckReader(options, options.Reader);
        else if (options.RecordingPath is not null)
            CheckRecording(options);
        else
            CheckSources(options);

        CheckNetwork(options);
        CheckCalculationPort(options);
        Require(options.QueueCapacity is >= 1 and <= 65_536, nameof(options.QueueCapacity), "must be 1 to 65,536 frames", options.QueueCapacity);
        Require(
            options.ClientTimeout == Timeout.InfiniteTimeSpan
                || (options.ClientTimeout >= TimeSpan.FromSeconds(1) && options.ClientTimeout <= TimeSpan.FromMinutes(10)),
            nameof(options.ClientTimeout),
            "must be 1 second to 10 minutes, or infinite",
            options.ClientTimeout);
        Require(
            options.CloseTimeout >= TimeSpan.Zero && options.CloseTimeout <= TimeSpan.FromMinutes(10),
            nameof(options.CloseTimeout),
            "must be 0 to 10 minutes",
            options.CloseTimeout);
    }

    public static ArgumentException Fault(string setting, string requirement, object? value) =>
        new($"{nameof(BroadcasterOptions)}.{setting} is {value ?? "null"}; it {requirement}.", setting);

    private static void CheckSources(BroadcasterOptions options)
    {
        Require(
            options.Sources.Count is >= 1 and <= MaxAvatars,
            nameof(options.Sources),
            "must hold 1 to 256 sources, one for each avatar",
            $"a list of {options.Sources.Count}");
        Require(options.Sources.All(source => source is not null), nameof(options.Sources), "must not contain null", "a list with null");
        Require(options.AvatarNames.All(name => name is not null), nameof(options.AvatarNames), "must not contain null", "a list with null");
        Require(
            options.AvatarNames.Count <= options.Sources.Count,
            nameof(options.AvatarNames),
            "must not hold more names than there are sources",
            $"a list of {options.AvatarNames.Count}");
        CheckFormat(options);
        CheckRate(options);
        Require(options.MaxFrames is null or >= 1, nameof(options.MaxFrames), "must be at least 1 frame", options.MaxFrames);
        Require(options.RecordingSpeed == 1, nameof(options.RecordingSpeed), "needs a RecordingPath; set FrameRate to change the speed of a source", options.RecordingSpeed);
        Require(!options.LoopRecording, nameof(options.LoopRecording), "needs a RecordingPath; use LoopedSource to loop a source", true);
    }

    private static void CheckReader(BroadcasterOptions options, NeuronReader reader)
    {
        CheckUnchanged(options, "a reader");
        Require(!reader.IsPlayback, nameof(options.Reader), "must receive from a server; set RecordingPath to send a file", "a reader that plays a file");
        Require(options.RecordingPath is null, nameof(options.RecordingPath), "must be null with a Reader", options.RecordingPath);
        Require(options.FrameRate is null, nameof(options.FrameRate), "must be null with a Reader, whose packets are sent when they arrive", options.FrameRate);
        Require(options.RecordingSpeed == 1, nameof(options.RecordingSpeed), "needs a RecordingPath", options.RecordingSpeed);
        Require(!options.LoopRecording, nameof(options.LoopRecording), "needs a RecordingPath", true);
    }

    private static void CheckRecording(BroadcasterOptions options)
    {
        CheckUnchanged(options, "a recording");
        Require(
            options.FrameRate is null or (>= 0.01 and <= 100_000) or BroadcasterOptions.MaxFrameRate,
            nameof(options.FrameRate),
            "must be 0.01 to 100,000 Hz, or MaxFrameRate",
            options.FrameRate);
        Require(options.RecordingSpeed is >= 0.01 and <= 100, nameof(options.RecordingSpeed), "must be 0.01 to 100", options.RecordingSpeed);
        Require(
            options.RecordingSpeed == 1 || options.FrameRate is null or < BroadcasterOptions.MaxFrameRate,
            nameof(options.RecordingSpeed),
            "must be 1 when FrameRate is MaxFrameRate",
            options.RecordingSpeed);
    }

    // Settings that would change packets have no meaning for packets that were received.
    private static void CheckUnchanged(BroadcasterOptions options, string content)
    {
        var ordinary = new BroadcasterOptions();
        (string Setting, object? Value, object? Ordinary)[] settings =
        [
            (nameof(options.Sources), options.Sources.Count, 0),
            (nameof(options.AvatarNames), options.AvatarNames.Count, 0),
            (nameof(options.MaxFrames), options.MaxFrames, null),
            (nameof(options.IncludeDisplacement), options.IncludeDisplacement, null),
            (nameof(options.IncludeReference), options.IncludeReference, ordinary.IncludeReference),
            (nameof(options.RotationOrder), options.RotationOrder, ordinary.RotationOrder),
            (nameof(options.Format), options.Format, ordinary.Format),
            (nameof(options.DataVersion), options.DataVersion, null),
            (nameof(options.Calculation), options.Calculation, null),
            (nameof(options.CalculationValueCount), options.CalculationValueCount, ordinary.CalculationValueCount),
            (nameof(options.StudioCalculation), options.StudioCalculation, null),
            (nameof(options.SendMotion), options.SendMotion, ordinary.SendMotion),
            (nameof(options.TextDecimals), options.TextDecimals, ordinary.TextDecimals),
            (nameof(options.TextQuirks), options.TextQuirks, ordinary.TextQuirks),
            (nameof(options.DataCommandLength), options.DataCommandLength, null),
        ];
        foreach ((string setting, object? value, object? usual) in settings)
            Require(Equals(value, usual), setting, $"has no effect on {content}, whose bytes are sent unchanged", value);
    }

    private static void CheckRate(BroadcasterOptions options)
    {
        double own = options.Sources[0].FrameRate;
        Require(
            options.FrameRate is null or (>= 0.01 and <= 100_000) or BroadcasterOptions.MaxFrameRate,
            nameof(options.FrameRate),
            "must be 0.01 to 100,000 Hz, or MaxFrameRate",
            options.FrameRate);
        Require(
            options.FrameRate is not null || own is >= 0.01 and <= 100_000,
            nameof(options.FrameRate),
            $"must be set, because the rate of the first source is {own}, not 0.01 to 100,000 Hz",
            "null");
    }

    private static void CheckNetwork(BroadcasterOptions options)
    {
        Require(options.Port is null or (>= 0 and <= 65_535), nameof(options.Port), "must be 0 to 65535", options.Port);
        Require(options.BindAddress is not null, nameof(options.BindAddress), "must be an address of this computer", "null");
        Require(options.MaxClients is >= 1 and <= 4096, nameof(options.MaxClients), "must be 1 to 4096 clients", options.MaxClients);
        Require(
            options.UdpDestinations.All(destination => destination is not null),
            nameof(options.UdpDestinations),
            "must not contain null",
            "a list with null");
        Require(
            options.UdpDestinations.All(destination => destination.Port != 0),
            nameof(options.UdpDestinations),
            "must have ports from 1 to 65535",
            "a list with port 0");
        Require(options.Fragment is null or (>= 1 and <= 1_048_576), nameof(options.Fragment), "must be 1 to 1,048,576 bytes", options.Fragment);
    }

    private static void CheckCalculationPort(BroadcasterOptions options)
    {
        int? port = options.CalculationPort;
        bool hasCalculation = options.Calculation is not null || options.StudioCalculation is not null;
        Require(port is null or (>= 0 and <= 65_535), nameof(options.CalculationPort), "must be 0 to 65535", port);
        Require(port is null || hasCalculation || options.RecordingPath is not null || options.Reader is not null, nameof(options.CalculationPort), "needs Calculation, StudioCalculation, a RecordingPath or a Reader", port);
        Require(port is null || options.SendMotion, nameof(options.CalculationPort), "must be null without SendMotion: the calculation packets then go to Port and UdpDestinations", port);
        Require(port is null or 0 || port != options.Port, nameof(options.CalculationPort), "must differ from Port", port);
        Require(
            port != 0 || options.UdpDestinations.Count == 0,
            nameof(options.CalculationPort),
            "must be 1 to 65535 with UdpDestinations, which cannot offer a free port",
            port);
        Require(options.SendMotion || hasCalculation, nameof(options.SendMotion), "must be true without Calculation or StudioCalculation: nothing would be sent", false);
    }

    private static void CheckFormat(BroadcasterOptions options)
    {
        Require(
            (int)options.RotationOrder is >= 0 and <= 5,
            nameof(options.RotationOrder),
            "must be one of the six orders",
            options.RotationOrder);
        Require(options.Format is >= BroadcastFormat.Binary and <= BroadcastFormat.Studio, nameof(options.Format), "must be Binary, Text or Studio", options.Format);
        Require(options.DataVersion?.TryGetLayout(out _) ?? true, nameof(options.DataVersion), "must be 1.0 or 1.1", options.DataVersion);
        Require(
            options.Format != BroadcastFormat.Text || options.DataVersion is null,
            nameof(options.DataVersion),
            "must be null for text, which carries no version",
            options.DataVersion);
        Require(
            options.Format != BroadcastFormat.Studio || options.DataVersion is null || options.DataVersion == DataVersion.Studio,
            nameof(options.DataVersion),
            "must be null or 1.1.0.1 when Format is Studio; its old header is Binary with the version 1.0.0.2",
            options.DataVersion);
        Require(
            options.Format != BroadcastFormat.Studio || options.Calculation is null,
            nameof(options.Calculation),
            "must be null when Format is Studio, which sends StudioCalculation",
            "set");
        Require(
            options.Format == BroadcastFormat.Studio || options.StudioCalculation is null,
            nameof(options.StudioCalculation),
            "must be null unless Format is Studio",
            "set");
        Require(
            options.TextDecimals is >= 0 and <= TextEncoder.MaxDecimals, nameof(options.TextDecimals), "must be 0 to 6 digits", options.TextDecimals);
        Require(
            (options.TextQuirks | TextQuirks.LineFeedOnly | TextQuirks.StrayZeros) == (TextQuirks.LineFeedOnly | TextQuirks.StrayZeros),
            nameof(options.TextQuirks),
            "must be a combination of LineFeedOnly and StrayZeros",
            options.TextQuirks);
        Require(
            options.CalculationValueCount is CalculationFrame.BodyValueCount or CalculationFrame.FullValueCount,
            nameof(options.CalculationValueCount),
            "must be 338 or 946 values",
            options.CalculationValueCount);
    }

    private static void Require(bool condition, string setting, string requirement, object? value)
    {
        if (!condition)
            throw Fault(setting, requirement, value);
    }
}
