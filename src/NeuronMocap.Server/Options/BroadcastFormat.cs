namespace NeuronMocap.Server;

/// <summary>
/// The packets that a <see cref="Broadcaster"/> sends: the "block type" of Axis Neuron's broadcasting page, or the packets of Axis Studio.
/// </summary>
public enum BroadcastFormat
{
    /// <summary>Packets of Axis Neuron and earlier servers. The header layout follows the data version.</summary>
    Binary,

    /// <summary>Lines of text, the block type String (protocol.md section 8).</summary>
    /// <remarks>
    /// Lines carry no version, no frame index and fewer digits. A calculation line does not name its avatar. With several avatars, only its position
    /// after the motion line identifies the avatar.
    /// </remarks>
    Text,

    /// <summary>Packets of Axis Studio (protocol.md section 9).</summary>
    /// <remarks>
    /// The data version is 1.1.0.1. The reserved fields hold the rotation order and a timecode. Calculation packets have Axis Studio's own layout.
    /// The timecode is computed from the frame number and the rate: frame 0 is 00:00:00:00.
    /// <para>
    /// Two details are inferred. The rotation order uses the numbers of the vendor's RotateOrders. The timecode is packed as 0x00HHMMSS, followed by
    /// the frame within the second.
    /// </para>
    /// <para>Programs with the vendor's b12 library crash on Axis Studio's stream because of a bug in that library.</para>
    /// </remarks>
    Studio,
}
