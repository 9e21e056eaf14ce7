#nullable enable
using System;

namespace NeuronMocap.Unity
{
    /// <summary>What a <see cref="MotionRecorder"/> writes.</summary>
    [Flags]
    public enum TakeFormats
    {
        /// <summary>Nothing.</summary>
        None = 0,

        /// <summary>BVH: for animation programs. The values of the stream, bit for bit.</summary>
        Bvh = 1,

        /// <summary>Recording (.nmrec): every byte as it arrived, with its time. Plays again as the live stream did.</summary>
        Recording = 2,
    }
}
