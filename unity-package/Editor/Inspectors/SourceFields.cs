#nullable enable

using System;
using System.Collections.Generic;
using System.Linq;

namespace NeuronMocap.Unity.EditorTools
{
    // The fields of a source that are relevant to its kind. Fields not named here are always relevant.
    internal static class SourceFields
    {
        private static readonly string[] Network = { "_transport", "_address", "_port", "_calculationPort", "_localAddress", "_reconnect", "_commandPort", "_rotationOrder", "_skeletonVariant" };
        private static readonly string[] Simulator = { "_performerCount", "_motion", "_simulatedFrameRate" };
        private static readonly string[] BvhFile = { "_file", "_bvhAsset", "_loop", "_speed" };
        private static readonly string[] Recording = { "_file", "_loop", "_speed", "_rotationOrder", "_skeletonVariant" };
        private static readonly string[] Resampling = { "_delay", "_interpolation" };
        private static readonly string[] Special = Network.Concat(Simulator).Concat(BvhFile).Concat(Recording).ToArray();

        // With several sources selected, a field is hidden unless it is relevant to all of them.
        public static HashSet<string> HiddenFor(IReadOnlyCollection<MocapSource> sources)
        {
            var hidden = new HashSet<string>(Special, StringComparer.Ordinal);
            hidden.ExceptWith(Special.Where(name => sources.All(source => Of(source.Kind).Contains(name, StringComparer.Ordinal))));
            if (!sources.All(source => source.Resample))
                hidden.UnionWith(Resampling);

            return hidden;
        }

        private static string[] Of(SourceKind kind) => kind switch
        {
            SourceKind.Simulator => Simulator,
            SourceKind.BvhFile => BvhFile,
            SourceKind.Recording => Recording,
            _ => Network,
        };
    }
}
