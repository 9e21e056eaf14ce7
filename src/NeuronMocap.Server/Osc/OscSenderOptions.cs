using NeuronMocap.Server.Osc;

namespace NeuronMocap.Server;

/// <summary>Settings of an <see cref="OscSender"/>.</summary>
/// <remarks>The sender copies the settings when it is created. Later changes have no effect.</remarks>
public sealed class OscSenderOptions
{
    private const int LongestPrefix = 64;

    /// <summary>Name or address of the computer that receives; also a broadcast address. Default: this computer.</summary>
    public string Host { get; set; } = "127.0.0.1";

    /// <summary>UDP port on which that computer receives, 1 to 65535. Default: 9000.</summary>
    public int Port { get; set; } = 9000;

    /// <summary>The start of all addresses: a slash, then printable ASCII characters that OSC does not reserve; at most 64. Default: "/neuron".</summary>
    public string Prefix { get; set; } = "/neuron";

    /// <summary>What the transforms are relative to. Default: <see cref="OscSpace.World"/>.</summary>
    public OscSpace Space { get; set; }

    /// <summary>Number of the only avatar to send; null for all. Default: null.</summary>
    public int? AvatarIndex { get; set; }

    /// <summary>Name of the only avatar to send, case-sensitive; null for all. Default: null.</summary>
    public string? AvatarName { get; set; }

    /// <summary>Largest number of poses per second for each avatar: 0.01 to 1000, or 0 for every frame. Default: 60.</summary>
    public double MaxRate { get; set; } = 60;

    /// <summary>The factor of all positions, more than 0. With 1, the default, they are in centimetres; with 0.01 in metres.</summary>
    public float Scale { get; set; } = 1;

    /// <summary>
    /// Size of the largest datagram in bytes, 512 to 65,507. A pose has about 4,600 bytes. Default: 1400, which every network carries in one piece.
    /// </summary>
    public int MaxDatagramSize { get; set; } = 1400;

    internal OscSettings ToSettings()
    {
        bool isPrefix = Prefix is { Length: >= 2 and <= LongestPrefix }
            && Prefix[0] == '/'
            && Prefix[^1] != '/'
            && string.Equals(OscHead.ToPart(Prefix.Replace("/", "")), Prefix.Replace("/", ""), StringComparison.Ordinal);
        OscSettings.Require(nameof(OscSenderOptions), isPrefix, nameof(Prefix), "must be a slash and printable ASCII characters that OSC does not reserve, 2 to 64", Prefix);
        OscSettings.Require(nameof(OscSenderOptions), Space is OscSpace.World or OscSpace.Local, nameof(Space), "must be World or Local", Space);
        return new OscSettings(Host, Port, MaxRate, Scale, MaxDatagramSize).Checked(nameof(OscSenderOptions));
    }
}
