using NeuronMocap.Server.Osc;

namespace NeuronMocap.Server;

/// <summary>Settings of a <see cref="VmcSender"/>.</summary>
/// <remarks>The sender copies the settings when it is created. Later changes have no effect.</remarks>
public sealed class VmcSenderOptions
{
    /// <summary>Name or address of the computer that receives; also a broadcast address. Default: this computer.</summary>
    public string Host { get; set; } = "127.0.0.1";

    /// <summary>UDP port on which that computer receives, 1 to 65535. Default: 39539, the usual port of VMC receivers.</summary>
    public int Port { get; set; } = 39539;

    /// <summary>Number of the avatar to send; null for any. Default: null.</summary>
    public int? AvatarIndex { get; set; }

    /// <summary>Name of the avatar to send, case-sensitive; null for any. Default: null.</summary>
    public string? AvatarName { get; set; }

    /// <summary>Largest number of poses per second: 0.01 to 1000, or 0 for every frame. Default: 60.</summary>
    public double MaxRate { get; set; } = 60;

    /// <summary>
    /// The factor of all positions, more than 0. Receivers move their model as far as the actor. To keep a smaller model from floating, set
    /// the height of the model's hips divided by that of the actor's hips. Default: 1.
    /// </summary>
    public float Scale { get; set; } = 1;

    /// <summary>
    /// Whether the root moves over the ground with the performer, instead of the hips. Set it for receivers that ignore positions of bones;
    /// their model then walks, too. Default: false.
    /// </summary>
    public bool MoveRoot { get; set; }

    /// <summary>
    /// Size of the largest datagram in bytes, 512 to 65,507. A pose has about 4,300 bytes. Default: 1400, which every network carries in one piece.
    /// </summary>
    public int MaxDatagramSize { get; set; } = 1400;

    internal OscSettings ToSettings() => new OscSettings(Host, Port, MaxRate, Scale, MaxDatagramSize).Checked(nameof(VmcSenderOptions));
}
