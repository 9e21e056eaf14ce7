#nullable enable
using System;

namespace NeuronMocap.Unity
{
    /// <summary>Specifies what a <see cref="MotionRecorder"/> writes.</summary>
    [Flags]
    public enum TakeFormats
    {
        /// <summary>Nothing.</summary>
        None = 0,

        /// <summary>BVH, for animation programs. It holds the values of the stream, bit for bit.</summary>
        Bvh = 1,

        /// <summary>A recording (.nmrec) of every byte as it arrived, with its time. It plays again like the live stream.</summary>
        Recording = 2,
    }
}
