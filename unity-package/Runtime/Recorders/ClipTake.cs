#nullable enable
using System;
using System.Collections.Generic;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>A take of a <see cref="ClipRecorder"/>: rows of values, one row for each frame.</summary>
    public sealed class ClipTake
    {
        private const int RowsPerBlock = 256;

        private readonly List<float[]> _blocks = new List<float[]>();
        private readonly int _width;

        internal ClipTake(IReadOnlyList<ClipProperty> properties, bool isHumanoid, float frameRate)
        {
            Properties = properties;
            IsHumanoid = isHumanoid;
            FrameRate = frameRate;
            foreach (ClipProperty property in properties)
                ValueCount += property.Components.Count;

            _width = ValueCount + 1;
        }

        // Set by the editor part of the package: creates the clip of a take, with an error allowed when keys are removed.
        internal static Func<ClipTake, float, AnimationClip>? Writer { get; set; }

        /// <summary>Gets whether the take plays on any Humanoid. Otherwise it plays only on a character with the same transforms.</summary>
        public bool IsHumanoid { get; }

        /// <summary>Gets the requested frame rate.</summary>
        public float FrameRate { get; }

        /// <summary>Gets the number of frames.</summary>
        public int FrameCount { get; private set; }

        /// <summary>Gets the time from the first frame to the last, in seconds.</summary>
        public float Length => FrameCount == 0 ? 0 : GetTime(FrameCount - 1);

        internal IReadOnlyList<ClipProperty> Properties { get; }

        internal int ValueCount { get; }

        internal float GetTime(int frame) => Block(frame)[Start(frame)];

        // The values of all properties are numbered consecutively.
        internal float GetValue(int frame, int value) => Block(frame)[Start(frame) + 1 + value];

        // Memory grows by blocks of several seconds, so most frames allocate nothing.
        internal void Add(float time, float[] values)
        {
            if (FrameCount % RowsPerBlock == 0)
                _blocks.Add(new float[RowsPerBlock * _width]);

            int frame = FrameCount++;
            float[] block = Block(frame);
            block[Start(frame)] = time;
            values.CopyTo(block, Start(frame) + 1);
        }

        private float[] Block(int frame) => _blocks[frame / RowsPerBlock];

        private int Start(int frame) => frame % RowsPerBlock * _width;
    }
}
