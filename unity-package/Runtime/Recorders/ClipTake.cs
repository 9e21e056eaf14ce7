#nullable enable
using System.Collections.Generic;

namespace NeuronMocap.Unity
{
    /// <summary>What a <see cref="ClipRecorder"/> has recorded: rows of values, one row for each frame.</summary>
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

        /// <summary>Whether it moves any humanoid; otherwise only a character with the same transforms.</summary>
        public bool IsHumanoid { get; }

        /// <summary>Frames per second that were asked for.</summary>
        public float FrameRate { get; }

        /// <summary>Number of frames.</summary>
        public int FrameCount { get; private set; }

        /// <summary>Seconds from the first frame to the last.</summary>
        public float Length => FrameCount == 0 ? 0 : GetTime(FrameCount - 1);

        internal IReadOnlyList<ClipProperty> Properties { get; }

        internal int ValueCount { get; }

        internal float GetTime(int frame) => Block(frame)[Start(frame)];

        // Values are numbered through all properties.
        internal float GetValue(int frame, int value) => Block(frame)[Start(frame) + 1 + value];

        // Memory grows by blocks of some seconds, so that most frames allocate nothing.
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
