namespace NeuronMocap.Server;

/// <summary>Specifies what the transforms of an <see cref="OscSender"/> are relative to.</summary>
public enum OscSpace
{
    /// <summary>The world: each bone has the place and the orientation that a camera would see.</summary>
    World = 0,

    /// <summary>The parent bone, as in the stream. The hips are in the world.</summary>
    Local,
}
