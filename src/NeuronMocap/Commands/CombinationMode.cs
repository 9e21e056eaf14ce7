namespace NeuronMocap.Commands;

/// <summary>The set of sensors that an avatar wears: the vendor's "SensorCombinationModes" (protocol.md section 2.4).</summary>
public enum CombinationMode
{
    /// <summary>One arm.</summary>
    ArmOnly = 0,

    /// <summary>The upper body.</summary>
    UpperBody = 1,

    /// <summary>The whole body.</summary>
    FullBody = 2,
}
