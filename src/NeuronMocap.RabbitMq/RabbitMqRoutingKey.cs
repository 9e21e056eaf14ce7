using System.Globalization;
using System.Text;
using NeuronMocap.RabbitMq.Connecting;

namespace NeuronMocap.RabbitMq;

/// <summary>
/// Routing keys of frames: <c>stage.avatar.kind</c>. Queues of your own can be bound to the exchange with them, for example with
/// <c>main.*.motion</c>.
/// </summary>
/// <remarks>
/// Names can contain characters that have a meaning in routing keys. <c>.</c>, <c>*</c>, <c>#</c>, <c>%</c> and control characters are written as
/// <c>%</c> and two hexadecimal digits for each byte of UTF-8: <c>Dr. Who</c> becomes <c>Dr%2E Who</c>. An empty name becomes <c>%</c>.
/// </remarks>
public static class RabbitMqRoutingKey
{
    // The rest of a key is for the avatar, 32 characters of at most three bytes, and for the kind.
    private const int MaxStageBytes = 128;

    private const string AnyWord = "*";
    private const string EmptyName = "%";

    /// <summary>Makes the routing key of a frame.</summary>
    /// <param name="stage">Name of the stage.</param>
    /// <param name="avatar">Name of the avatar.</param>
    /// <param name="kind">Motion, Calculation or StudioCalculation.</param>
    /// <returns>The key, such as <c>main.Char00.motion</c>.</returns>
    /// <exception cref="ArgumentOutOfRangeException">Frames do not have this kind.</exception>
    public static string Create(string stage, string avatar, PacketKind kind) => $"{Escape(stage)}.{Escape(avatar)}.{NameOf(kind)}";

    /// <summary>Makes the pattern that binds a queue to the frames of a stage.</summary>
    /// <param name="stage">Name of the stage.</param>
    /// <param name="avatar">Name of the avatar; null for all avatars.</param>
    /// <param name="kind">The kind of frames; null for all kinds.</param>
    /// <returns>The pattern, such as <c>main.*.motion</c>.</returns>
    /// <exception cref="ArgumentOutOfRangeException">Frames do not have this kind.</exception>
    public static string CreatePattern(string stage, string? avatar = null, PacketKind? kind = null) =>
        $"{Escape(stage)}.{(avatar is null ? AnyWord : Escape(avatar))}.{(kind is { } one ? NameOf(one) : AnyWord)}";

    /// <summary>Makes one word of a routing key from a name.</summary>
    /// <param name="name">Any text.</param>
    /// <returns>The name without characters that have a meaning in routing keys. Different names give different words.</returns>
    public static string Escape(string name)
    {
        ArgumentNullException.ThrowIfNull(name);
        if (name.Length == 0)
            return EmptyName;

        var word = new StringBuilder(name.Length);
        foreach (char one in name)
        {
            if (one is '.' or '*' or '#' or '%' || char.IsControl(one))
            {
                foreach (byte part in Encoding.UTF8.GetBytes([one]))
                    word.Append('%').Append(part.ToString("X2", CultureInfo.InvariantCulture));
            }
            else
            {
                word.Append(one);
            }
        }

        return word.ToString();
    }

    internal static string NameOf(PacketKind kind) => kind switch
    {
        PacketKind.Motion => "motion",
        PacketKind.Calculation => "calculation",
        PacketKind.StudioCalculation => "studio-calculation",
        _ => throw new ArgumentOutOfRangeException(nameof(kind), kind, "Frames have the kind Motion, Calculation or StudioCalculation."),
    };

    internal static bool TryGetKind(string name, out PacketKind kind)
    {
        kind = name switch
        {
            "motion" => PacketKind.Motion,
            "calculation" => PacketKind.Calculation,
            "studio-calculation" => PacketKind.StudioCalculation,
            _ => PacketKind.None,
        };
        return kind != PacketKind.None;
    }

    // As the broker does it, for streams, which have no binding of their consumer's.
    internal static bool Matches(string pattern, string key)
    {
        string[] wanted = pattern.Split('.');
        string[] words = key.Split('.');
        if (wanted.Length != words.Length)
            return false;

        for (int i = 0; i < words.Length; i++)
        {
            if (!string.Equals(wanted[i], AnyWord, StringComparison.Ordinal) && !string.Equals(wanted[i], words[i], StringComparison.Ordinal))
                return false;
        }

        return true;
    }

    internal static string? FindFaultOfStage(string stage)
    {
        if (string.IsNullOrWhiteSpace(stage))
            return "Stage is empty; it must be a name.";

        return Encoding.UTF8.GetByteCount(Escape(stage)) <= MaxStageBytes && AmqpName.Fits(Create(stage, string.Empty, PacketKind.Motion))
            ? null
            : $"Stage is too long; its word in a routing key must have at most {MaxStageBytes} bytes.";
    }
}
