using System.Globalization;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>The avatar that a destination names: by its number, if the text is a number; otherwise by its name.</summary>
/// <param name="Text">The part of the destination behind the port.</param>
internal sealed record NamedAvatar(string Text)
{
    // As many as fit beside the other columns.
    private const int MostNamed = 4;

    /// <summary>The number; null if the avatar is named by its name.</summary>
    public int? Index => int.TryParse(Text, NumberStyles.None, CultureInfo.InvariantCulture, out int index) ? index : null;

    /// <summary>The name; null if the avatar is named by its number.</summary>
    public string? Name => Index is null ? Text : null;

    /// <summary>Whether an avatar of the stream is meant.</summary>
    public bool Is(AvatarStatistics avatar) =>
        Index is { } index ? index == avatar.AvatarIndex : string.Equals(Text, avatar.AvatarName, StringComparison.Ordinal);

    /// <summary>Says which avatars arrive instead.</summary>
    public string DescribeMissing(IReadOnlyCollection<AvatarStatistics> arriving)
    {
        string wanted = Index is { } index ? string.Create(CultureInfo.InvariantCulture, $"performer {index}") : $"performer '{Text}'";
        IEnumerable<string> named = arriving.Take(MostNamed).Select(DescribeArriving);
        string more = arriving.Count > MostNamed ? string.Create(CultureInfo.InvariantCulture, $" and {arriving.Count - MostNamed} more") : string.Empty;
        return $"no {wanted}; arriving: {string.Join(", ", named)}{more}";
    }

    // As the destination would name them.
    private string DescribeArriving(AvatarStatistics avatar) =>
        Index is null && avatar.AvatarName.Length > 0 ? avatar.AvatarName : avatar.AvatarIndex.ToString(CultureInfo.InvariantCulture);
}
