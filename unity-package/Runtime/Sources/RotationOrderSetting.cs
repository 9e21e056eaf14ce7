#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>The rotation order of the inspector: one of the six, or found out.</summary>
    public enum RotationOrderSetting
    {
        /// <summary>What the frames or the command channel say; else YXZ, Axis Neuron's default.</summary>
        Auto,

        /// <summary>X, then Y, then Z.</summary>
        XYZ,

        /// <summary>X, then Z, then Y.</summary>
        XZY,

        /// <summary>Y, then X, then Z: Axis Neuron's default.</summary>
        YXZ,

        /// <summary>Y, then Z, then X.</summary>
        YZX,

        /// <summary>Z, then X, then Y.</summary>
        ZXY,

        /// <summary>Z, then Y, then X.</summary>
        ZYX,
    }
}
