#nullable enable

using NeuronMocap.Skeleton;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // What a connection is made of: sources whose settings are equal share one. Nobody changes it after it was made; the setters are there because
    // Unity's C# has no init-only ones. What has no meaning for a kind stays at its default, so that it makes no difference.
    internal sealed record SourceSettings
    {
        public SourceKind Kind { get; set; }

        public string Address { get; set; } = string.Empty;

        public int Port { get; set; }

        public int? CalculationPort { get; set; }

        public TransportKind Transport { get; set; }

        public string LocalAddress { get; set; } = string.Empty;

        public bool Reconnect { get; set; }

        public int? CommandPort { get; set; }

        public RotationOrder? RotationOrder { get; set; }

        public SkeletonVariant? Variant { get; set; }

        public int Performers { get; set; }

        public SimulatedMotion Motion { get; set; }

        public float FrameRate { get; set; }

        public string File { get; set; } = string.Empty;

        public TextAsset? Asset { get; set; }

        // Of the file or the asset; read on the main thread, which alone may ask an asset.
        public string Name { get; set; } = string.Empty;

        public bool Loop { get; set; }

        public float Speed { get; set; }

        // What messages call it.
        public string Target => Kind switch
        {
            SourceKind.Network => Transport == TransportKind.Tcp ? $"{Address}:{Port}" : $"UDP port {Port}",
            SourceKind.Simulator => "the simulator",
            _ => $"file {Name}",
        };
    }
}
