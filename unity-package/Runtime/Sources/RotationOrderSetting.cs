#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>The rotation order in the inspector: one of the six, or automatic.</summary>
    public enum RotationOrderSetting
    {
        /// <summary>The order from the frames or the command channel, or else YXZ, Axis Neuron's default.</summary>
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
