using System.Diagnostics.CodeAnalysis;
using System.Globalization;

namespace NeuronMocap.Tool.View.Performers;

/// <summary>Identifies a performer: the number of the sender, and that of the avatar. As text, "SENDER-AVATAR".</summary>
/// <param name="Sender">The number of the sender, from 0.</param>
/// <param name="Avatar">The number of the avatar in the stream.</param>
internal readonly record struct PerformerKey(int Sender, int Avatar)
{
    public static PerformerKey Of(AvatarFrame frame) => new(frame.Sender, frame.AvatarIndex);

    public static PerformerKey Of(in AvatarStatistics statistics) => new(statistics.Sender, statistics.AvatarIndex);

    /// <summary>Parses the text of a key.</summary>
    public static bool TryParse([NotNullWhen(true)] string? text, out PerformerKey key)
    {
        key = default;
        if (text?.Split('-') is not [var first, var second]
            || !int.TryParse(first, NumberStyles.None, CultureInfo.InvariantCulture, out int sender)
            || !uint.TryParse(second, NumberStyles.None, CultureInfo.InvariantCulture, out uint avatar))
        {
            return false;
        }

        key = new PerformerKey(sender, (int)avatar);
        return true;
    }

    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{Sender}-{(uint)Avatar}");
}
