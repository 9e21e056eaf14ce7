#nullable enable
using System;
using System.Collections.Generic;

namespace NeuronMocap.Unity
{
    // A group of values that a clip animates together: a muscle, or the components of a position or rotation.
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

        // The path from the animated object to the transform. Empty for the object itself.
        public string Path { get; }

        public string Name { get; }

        // The suffixes of the name, in the order of the values.
        public IReadOnlyList<string> Components { get; }

        // Whether it is a property of a Transform. Otherwise it belongs to the Animator.
        public bool IsTransform { get; }

        public bool IsRotation => Components.Count == 4;

        public bool IsSame(ClipProperty other) =>
            string.Equals(Path, other.Path, StringComparison.Ordinal) && string.Equals(Name, other.Name, StringComparison.Ordinal);

        public static ClipProperty Muscle(string name) => new ClipProperty("", name, Single, false);

        // part: the root, or a foot or hand.
        public static ClipProperty BodyPosition(string part) => new ClipProperty("", part + "T", Vector, false);

        public static ClipProperty BodyRotation(string part) => new ClipProperty("", part + "Q", Rotation, false);

        public static ClipProperty LocalPosition(string path) => new ClipProperty(path, "m_LocalPosition", Vector, true);

        public static ClipProperty LocalRotation(string path) => new ClipProperty(path, "m_LocalRotation", Rotation, true);
    }
}
