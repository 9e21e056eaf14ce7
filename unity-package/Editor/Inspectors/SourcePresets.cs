#nullable enable

using System;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Where motion usually comes from.
    internal static class SourcePresets
    {
        public const string Label = "Preset";

        private const string ThisComputer = "127.0.0.1";

        private static readonly (string Name, SourceKind Kind, TransportKind Transport, int Port)[] Presets =
        {
            ("Simulator", SourceKind.Simulator, default, 0),
            ("Axis Neuron on This Computer (TCP 7001)", SourceKind.Network, TransportKind.Tcp, 7001),
            ("Axis Studio on This Computer (UDP 7012)", SourceKind.Network, TransportKind.Udp, 7012),
            ("BVH File", SourceKind.BvhFile, default, 0),
            ("Recording", SourceKind.Recording, default, 0),
        };

        private static readonly GUIContent[] Options = Presets.Select(preset => preset.Name).Append("Custom").Select(name => new GUIContent(name)).ToArray();

        private static readonly GUIContent Content = new GUIContent(
            Label, "Sets Kind, Transport, Address and Port together. Choose the same port and transport in the broadcasting settings of Axis Neuron or Axis Studio.");

        // Returns the index of a preset that was just chosen.
        public static int? Draw(MocapSource[] sources)
        {
            int shown = Find(sources[0]);
            int chosen = EditorGUILayout.Popup(Content, shown, Options);
            return chosen == shown || chosen == Presets.Length ? (int?)null : chosen;
        }

        public static void Apply(int index, MocapSource[] sources)
        {
            Undo.RecordObjects(sources, Label);
            foreach (MocapSource source in sources)
            {
                source.Kind = Presets[index].Kind;
                if (source.Kind == SourceKind.Network)
                    (source.Transport, source.Address, source.Port) = (Presets[index].Transport, ThisComputer, Presets[index].Port);

                PrefabUtility.RecordPrefabInstancePropertyModifications(source);
            }
        }

        private static int Find(MocapSource source)
        {
            int found = Array.FindIndex(Presets, preset => preset.Kind == source.Kind && (preset.Kind != SourceKind.Network
                || (preset.Transport == source.Transport && preset.Port == source.Port
                    && (preset.Transport != TransportKind.Tcp || string.Equals(source.Address.Trim(), ThisComputer, StringComparison.Ordinal)))));
            return found >= 0 ? found : Presets.Length;
        }
    }
}
