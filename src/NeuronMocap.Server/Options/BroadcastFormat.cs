namespace NeuronMocap.Server;

/// <summary>What a <see cref="Broadcaster"/> puts on the wire: the "block type" of Axis Neuron's broadcasting page, and whose packets.</summary>
public enum BroadcastFormat
{
    /// <summary>Packets as Axis Neuron sends them, and servers before it: the header's layout follows the data version.</summary>
    Binary,

    /// <summary>
    /// Lines of text, the block type String (protocol.md section 8). They carry no version, no frame index and fewer digits. A calculation line
    /// does not even say whose it is: with several avatars only its place behind the motion line tells.
    /// </summary>
    Text,

    /// <summary>
    /// Packets as Axis Studio sends them (protocol.md section 9): data version 1.1.0.1, the rotation order and a timecode in the reserved fields,
    /// and calculation packets of its own kind. The timecode is computed from the frame number and the rate: frame 0 is 00:00:00:00. That the
    /// order counts as the vendor's RotateOrders does, and how the timecode is packed (0x00HHMMSS, then the frame within the second), is inferred.
    /// Programs with the vendor's b12 library crash on Axis Studio's stream, by a fault of their own.
    /// </summary>
    Studio,
}
