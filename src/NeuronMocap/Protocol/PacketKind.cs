namespace NeuronMocap;

/// <summary>What a packet on a data connection carries, as its first token says.</summary>
public enum PacketKind : byte
{
    /// <summary>No packet. Never the kind of one that was found.</summary>
    None,

    /// <summary>BVH data, token 0xDDFF: positions and rotations of one avatar at one instant.</summary>
    Motion,

    /// <summary>Calculation data, token 0x88FF: global positions, velocities and sensor readings of one avatar at one instant.</summary>
    Calculation,

    /// <summary>A command of the old generation, token 0xAAFF, which shares the data connection (protocol.md section 7).</summary>
    Command,

    /// <summary>Axis Studio's calculation data, token 0xDCCF: what each sensor and each bone of one avatar does at one instant (protocol.md section 9).</summary>
    StudioCalculation,
}
