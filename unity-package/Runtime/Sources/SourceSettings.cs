#nullable enable

using NeuronMocap.Skeleton;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // The settings of a connection. Sources with equal settings share one. Settings are not changed after creation; the setters exist because Unity's
    // C# has no init-only setters. Settings irrelevant to a kind stay at their defaults, so that they do not affect equality.
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

        // Name of the file or the asset. Read on the main thread, because only the main thread may access an asset.
        public string Name { get; set; } = string.Empty;

        public bool Loop { get; set; }

        public float Speed { get; set; }

        public bool IsFile => Kind is SourceKind.BvhFile or SourceKind.Recording;

        public bool IsUdp => Kind == SourceKind.Network && Transport == TransportKind.Udp;

        // The name used in messages.
        public string Target => Kind switch
        {
            SourceKind.Network => Transport == TransportKind.Tcp ? $"{Address}:{Port}" : $"UDP port {Port}",
            SourceKind.Simulator => "the simulator",
            _ => $"file {Name}",
        };
    }
}
