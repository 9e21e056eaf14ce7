#nullable enable
using System.Collections.Generic;

namespace NeuronMocap.Unity
{
    // What a clip animates with numbers that belong together: a muscle, or the components of a position or rotation.
    internal sealed class ClipProperty
    {
        private static readonly string[] Single = { "" };
        private static readonly string[] Vector = { ".x", ".y", ".z" };
        private static readonly string[] Rotation = { ".x", ".y", ".z", ".w" };

        private ClipProperty(string path, string name, string[] components, bool isTransform)
        {
            Path = path;
            Name = name;
            Components = components;
            IsTransform = isTransform;
        }

        // From the animated object down to the transform; empty for itself.
        public string Path { get; }

        public string Name { get; }

        // What follows the name, in the order of the values.
        public IReadOnlyList<string> Components { get; }

        // Of a Transform; otherwise of the Animator.
        public bool IsTransform { get; }

        public bool IsRotation => Components.Count == 4;

        public static ClipProperty Muscle(string name) => new ClipProperty("", name, Single, false);

        public static ClipProperty RootPosition() => new ClipProperty("", "RootT", Vector, false);

        public static ClipProperty RootRotation() => new ClipProperty("", "RootQ", Rotation, false);

        public static ClipProperty LocalPosition(string path) => new ClipProperty(path, "m_LocalPosition", Vector, true);

        public static ClipProperty LocalRotation(string path) => new ClipProperty(path, "m_LocalRotation", Rotation, true);
    }

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
