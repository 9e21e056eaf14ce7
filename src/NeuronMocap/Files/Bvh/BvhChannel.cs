namespace NeuronMocap.Bvh;

/// <summary>Specifies what a value of a BVH row moves or turns. The names are those of the file.</summary>
public enum BvhChannel
{
    /// <summary>A channel name that the format does not define. Its value keeps its place in the row and has no meaning.</summary>
    Unknown = 0,

    /// <summary>Position along X, in the file's unit of length.</summary>
    Xposition,

    /// <summary>Position along Y, in the file's unit of length.</summary>
    Yposition,

    /// <summary>Position along Z, in the file's unit of length.</summary>
    Zposition,

    /// <summary>Rotation about X, in degrees.</summary>
    Xrotation,

    /// <summary>Rotation about Y, in degrees.</summary>
    Yrotation,

    /// <summary>Rotation about Z, in degrees.</summary>
    Zrotation,
}
