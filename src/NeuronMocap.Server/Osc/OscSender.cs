using System.Diagnostics;
using NeuronMocap.Server.Osc;

namespace NeuronMocap.Server;

/// <summary>Sends all avatars, or one, as plain OSC messages, for programs such as TouchDesigner, Max and Pure Data.</summary>
/// <remarks>
/// <para>
/// Each bone is a message <c>/neuron/AVATAR/BONE px py pz qx qy qz qw</c> of seven floats: the position in centimetres and a unit quaternion. The axes are
/// the library's: right-handed, Y up, X to the performer's left, Z forward. After the 59 bones, <c>/neuron/AVATAR/frame</c> has the frame number as an int,
/// or -1, and the seconds since the sender was created as a float.
/// </para>
/// <para>
/// AVATAR is the name of the avatar. Characters that OSC reserves, and those outside of ASCII, become underscores. If two avatars have one name, the
/// second one's number follows its name: <c>Ann-1</c>. An avatar without a name is <c>avatar0</c>, with its number.
/// </para>
/// </remarks>
public sealed class OscSender : PoseSender
{
    /// <summary>Creates a sender without starting it.</summary>
    /// <param name="reader">Receives the poses. It belongs to the caller.</param>
    /// <param name="options">The settings, which are copied; null for the defaults.</param>
    /// <exception cref="ArgumentException">A setting is out of range, and the message names it.</exception>
    public OscSender(NeuronReader reader, OscSenderOptions? options = null)
        : this(reader ?? throw new ArgumentNullException(nameof(reader)), options ?? new OscSenderOptions(), Stopwatch.GetTimestamp())
    {
    }

    private OscSender(NeuronReader reader, OscSenderOptions options, long start)
        : this(reader, options, new AvatarPoses(new AvatarChoice(options.AvatarIndex, options.AvatarName, onlyOne: false)), start)
    {
    }

    private OscSender(NeuronReader reader, OscSenderOptions options, AvatarPoses poses, long start)
        : base(reader, options.ToSettings(), poses, new OscPoseEncoder(poses, options.Prefix, options.Space, options.Scale, start))
    {
    }
}
