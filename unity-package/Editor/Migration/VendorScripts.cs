#nullable enable

using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;

namespace NeuronMocap.Unity.EditorTools
{
    // The vendor's components, by the names of their classes and by the GUIDs of their script files.
    internal static class VendorScripts
    {
        public const string AnimatorInstance = "NeuronAnimatorInstance";
        public const string TransformsInstance = "NeuronTransformsInstance";

        private const string Namespace = "Neuron";
        private const string Headset = "A headset moves the head in the sample VR Head.";
        private const string RigidBodies = "The broadcast stream has no rigid bodies and trackers.";

        private static readonly VendorScript[] Known =
        {
            new VendorScript(AnimatorInstance, VendorKind.Humanoid),
            new VendorScript(TransformsInstance, VendorKind.Generic),
            new VendorScript("NeuronInstance", VendorKind.None, "It receives, but moves nothing. In a script, use the performers of a Mocap Source."),
            new VendorScript("NeuronInstancesManager", VendorKind.None, "Its address is not in the scene: a script passes it to Connect. Add a Performer Spawner, and set its Source and, to the replica prefab, its Prefab."),
            new VendorScript("NeuronSourceManager", VendorKind.None, "Each Mocap Source has its own address and port."),
            new VendorScript("NeuronTransformsInstanceVR", VendorKind.None, Headset),
            new VendorScript("NeuronVRAdapter", VendorKind.None, Headset),
            new VendorScript("NeuronOVRAdapter", VendorKind.None, Headset),
            new VendorScript("TranceTransformsInstance", VendorKind.None, "There is no equivalent. Use a Generic Rig Driver for the rig."),
            new VendorScript("NeuronRigidbody", VendorKind.None, RigidBodies),
            new VendorScript("NeuronTracker", VendorKind.None, RigidBodies),
            new VendorScript("BoneLine", VendorKind.None, "Use a Skeleton View, which draws all bones of a performer."),
            new VendorScript("FPSCounter", VendorKind.None, "Use Unity's Profiler or the statistics of the game view."),
        };

        // The GUIDs of the vendor's own files, which scenes keep when the scripts are gone.
        private static readonly Dictionary<string, string> NamesByGuid = new Dictionary<string, string>(StringComparer.Ordinal)
        {
            ["41173daca41f9a64b8552925c6a3c363"] = AnimatorInstance,
            ["b9f969a3a049578478f71ba66294d9d5"] = TransformsInstance,
        };

        // The vendor's script of a class, or null. A class that derives from one of them has code of its own.
        public static VendorScript? Of(Type type)
        {
            if (Find(type) is { } script)
                return script;

            for (Type? above = type.BaseType; above != null; above = above.BaseType)
            {
                if (Find(above) is { } parent)
                    return new VendorScript(type.Name, VendorKind.None, $"It derives from {parent.Name} and has code of its own, which must be rewritten.");
            }

            return null;
        }

        // All scripts of the vendor that files of this project can name, by GUID.
        public static IReadOnlyDictionary<string, VendorScript> FindGuids()
        {
            var found = new Dictionary<string, VendorScript>(StringComparer.Ordinal);
            foreach (KeyValuePair<string, string> known in NamesByGuid)
                found.Add(known.Key, new VendorScript(known.Value, Find(known.Value)!.Kind, isMissing: true));

            foreach (string guid in Known.SelectMany(script => AssetDatabase.FindAssets($"{script.Name} t:MonoScript")).Distinct(StringComparer.Ordinal))
            {
                Type? type = AssetDatabase.LoadAssetAtPath<MonoScript>(AssetDatabase.GUIDToAssetPath(guid))?.GetClass();
                if (type != null && Of(type) is { } script)
                    found[guid] = script;
            }

            return found;
        }

        private static VendorScript? Find(Type type)
        {
            bool isVendors = type.Namespace is Namespace || (string.IsNullOrEmpty(type.Namespace) && type.Name.StartsWith(Namespace, StringComparison.Ordinal));
            return isVendors ? Find(type.Name) : null;
        }

        private static VendorScript? Find(string name) => Array.Find(Known, script => string.Equals(script.Name, name, StringComparison.Ordinal));
    }
}
