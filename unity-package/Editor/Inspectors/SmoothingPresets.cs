#nullable enable

using System;
using System.Linq;
using NeuronMocap.Retargeting;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Ready settings of a figure's smoothing.
    internal static class SmoothingPresets
    {
        public const string Label = "Smoothing Preset";

        // The weakest setting. It adds 5 ms.
        private static readonly SmoothingAmount Least = new SmoothingAmount(30, 20);

        private static readonly (string Name, SmoothingAmount? Body, SmoothingAmount? Fingers)[] Presets =
        {
            ("Off", null, null),
            ("Light", new SmoothingAmount(6, 4), new SmoothingAmount(6, 4)),
            ("Medium", new SmoothingAmount(3, 2), new SmoothingAmount(2, 2)),
            ("Strong", new SmoothingAmount(1, 1), new SmoothingAmount(1, 1)),
            ("Fingers Only", Least, new SmoothingAmount(2, 2)),
        };

        private static readonly GUIContent[] Options = Presets.Select(preset => preset.Name).Append("Custom").Select(name => new GUIContent(name)).ToArray();

        private static readonly GUIContent Content = new GUIContent(
            Label, "Sets Smoothing and all body parts: Light for clean streams, Medium for most, Strong for slow motion, Fingers Only for noisy gloves.");

        // Returns the index of a preset that was just chosen.
        public static int? Draw(UnityEngine.Object[] drivers)
        {
            int shown = Find((FigureDriver)drivers[0]);
            int chosen = EditorGUILayout.Popup(Content, shown, Options);
            return chosen == shown || chosen == Presets.Length ? (int?)null : chosen;
        }

        public static void Apply(int index, UnityEngine.Object[] drivers)
        {
            Undo.RecordObjects(drivers, Label);
            foreach (FigureDriver driver in drivers.Cast<FigureDriver>())
            {
                driver.Smoothing = Presets[index].Body.HasValue;
                if (Presets[index].Body is { } body)
                {
                    driver.PartSmoothing.Set(BodyParts.All, body);
                    driver.PartSmoothing.Set(BodyParts.Fingers, Presets[index].Fingers!.Value);
                }

                PrefabUtility.RecordPrefabInstancePropertyModifications(driver);
            }
        }

        private static int Find(FigureDriver driver)
        {
            int found = Array.FindIndex(Presets, preset => preset.Body is { } body
                ? driver.Smoothing && Is(driver, BodyParts.All & ~BodyParts.Fingers, body) && Is(driver, BodyParts.Fingers, preset.Fingers!.Value)
                : !driver.Smoothing);
            return found >= 0 ? found : Presets.Length;
        }

        private static bool Is(FigureDriver driver, BodyParts parts, SmoothingAmount amount)
        {
            for (BodyParts part = BodyParts.Hips; part <= BodyParts.RightLeg; part = (BodyParts)((int)part << 1))
            {
                if ((parts & part) != BodyParts.None && driver.PartSmoothing.Get(part).ToSettings() != amount.ToSettings())
                    return false;
            }

            return true;
        }
    }
}
