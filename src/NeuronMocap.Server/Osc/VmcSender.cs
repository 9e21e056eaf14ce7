using System.Diagnostics;
using NeuronMocap.Server.Osc;

namespace NeuronMocap.Server;

/// <summary>
/// Sends one avatar to a program that receives the Virtual Motion Capture protocol (VMC), such as VSeeFace, Warudo, VMagicMirror, EVMC4U and VRM4U.
/// </summary>
/// <remarks>
/// <para>
/// Each frame goes out as bundles of OSC messages: the root, 50 Humanoid bones, and then OK and T, on which receivers show the frame. Positions and
/// rotations are relative to the parent bone, in Unity's axes and metres. Rotations are those of a model without rotations in the T-pose, as the protocol
/// asks for.
/// </para>
/// <para>
/// A receiver has one port for each performer. Create a sender for each. Without a choice in the options, the first avatar that arrives is sent. Another one
/// takes its place when it has been silent for two seconds.
/// </para>
/// <para>The page docs/guide/avatars.md says what to set in the programs.</para>
/// </remarks>
public sealed class VmcSender : PoseSender
{
    /// <summary>Creates a sender without starting it.</summary>
    /// <param name="reader">Receives the poses. It belongs to the caller.</param>
    /// <param name="options">The settings, which are copied; null for the defaults.</param>
    /// <exception cref="ArgumentException">A setting is out of range, and the message names it.</exception>
    public VmcSender(NeuronReader reader, VmcSenderOptions? options = null)
        : this(reader ?? throw new ArgumentNullException(nameof(reader)), options ?? new VmcSenderOptions(), Stopwatch.GetTimestamp())
    {
    }

    private VmcSender(NeuronReader reader, VmcSenderOptions options, long start)
        : base(
            reader,
            options.ToSettings(),
            new AvatarPoses(new AvatarChoice(options.AvatarIndex, options.AvatarName, onlyOne: true)),
            new VmcEncoder(options.Scale, options.MoveRoot, start))
    {
    }
}
