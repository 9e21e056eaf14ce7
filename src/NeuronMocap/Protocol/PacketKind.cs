namespace NeuronMocap;

/// <summary>The kind of a packet on a data connection, according to its first token.</summary>
public enum PacketKind : byte
{
    /// <summary>Not a packet. A packet that was found never has this kind.</summary>
    None,

    /// <summary>BVH data, token 0xDDFF: positions and rotations of one avatar at one moment.</summary>
    Motion,

    /// <summary>Calculation data, token 0x88FF: global positions, velocities and sensor readings of one avatar at one moment.</summary>
    Calculation,

    /// <summary>A command of the old generation, token 0xAAFF, which shares the data connection (protocol.md section 7).</summary>
    Command,

    /// <summary>
    /// Axis Studio's calculation data, token 0xDCCF (protocol.md section 9). It has the readings of each sensor and the motion of each bone
    /// of one avatar at one moment.
    /// </summary>
    StudioCalculation,
}
