using NeuronMocap.Protocol;

namespace NeuronMocap.Diagnostics;

// Describes a stream in words.
internal static class StreamPhrases
{
    private const int MaxNames = 4;

    public static string Describe(AvatarSample[] avatars)
    {
        AvatarSample first = avatars[0];
        double rate = avatars.Min(static avatar => avatar.FrameRate);
        string frequency = rate > 0 ? FormattableString.Invariant($", {rate:0.0} frames per second{(avatars.Length > 1 ? " of each" : string.Empty)}") : string.Empty;
        string version = first.Version == DataVersion.None ? "as text" : $"version {first.Version}";
        return $"{NameOf(first.Kind)}, {version}, {DescribeFormat(first)}; {DescribeAvatars(avatars)}{frequency}";
    }

    public static string DescribeFormat(AvatarSample avatar) => avatar.Kind == PacketKind.Motion
        ? $"{CountedNoun.Of(avatar.ValueCount, "value")}, displacement {OnOff(avatar.HasDisplacement)}, reference {OnOff(avatar.HasReference)}"
        : $"{CountedNoun.Of(avatar.ValueCount, "value")}";

    public static string DescribeAvatars(AvatarSample[] avatars)
    {
        string names = string.Join(", ", avatars.Take(MaxNames).Select(NameOf));
        string more = avatars.Length > MaxNames ? $" and {avatars.Length - MaxNames} more" : string.Empty;
        return $"{CountedNoun.Of(avatars.Length, "avatar")}: {names}{more}";
    }

    public static string NameOf(AvatarSample avatar) => $"{avatar.Index} {avatar.Name}".TrimEnd();

    public static string ProducerOf(AvatarSample avatar) => avatar.Kind != PacketKind.Motion
        ? string.Empty
        : avatar.Version == DataVersion.Studio ? ", as Axis Studio sends" : ", the new header";

    // For example "motion (BVH) data" or "motion (BVH) and calculation data".
    public static string KindsOf(StreamSample sample)
    {
        PacketKind[] kinds = [.. ((PacketKind[])[PacketKind.Motion, PacketKind.Calculation, PacketKind.StudioCalculation]).Where(sample.Has)];
        return string.Join(" and ", kinds.Select(WordsOf)) + " data";
    }

    public static string NameOf(PacketKind kind) => WordsOf(kind) + " data";

    private static string WordsOf(PacketKind kind) => kind switch
    {
        PacketKind.Motion => "motion (BVH)",
        PacketKind.Calculation => "calculation",
        _ => "Axis Studio's calculation",
    };

    private static string OnOff(bool value) => value ? "on" : "off";
}
