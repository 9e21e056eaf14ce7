#nullable enable

using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Draws reports in colours that are readable on both of Unity's skins.
    internal static class ReportGui
    {
        private const string Dot = "\u25cf";
        private const float DotWidth = 16f;
        private const float NameWidth = 130f;

        private static readonly Dictionary<(Severity, bool), GUIStyle> Styles = new Dictionary<(Severity, bool), GUIStyle>();

        public static void Headline(Severity severity, string title)
        {
            using (new EditorGUILayout.HorizontalScope())
            {
                DrawDot(severity);
                EditorGUILayout.LabelField(title, EditorStyles.boldLabel);
            }
        }

        public static void Row(in ReportRow row) => EditorGUILayout.LabelField(row.Name, row.Value, StyleOf(row.Severity));

        public static void Step(in ReportRow step)
        {
            using (new EditorGUILayout.HorizontalScope())
            {
                DrawDot(step.Severity);
                EditorGUILayout.LabelField(step.Name, step.Value, EditorStyles.wordWrappedMiniLabel);
            }
        }

        // Draws a row that can be clicked. isShown: the performer is in the preview. Returns true if the row was clicked.
        public static bool Performer(PerformerRow row, bool isShown)
        {
            using (new EditorGUILayout.HorizontalScope())
            {
                DrawDot(row.Severity);
                bool isOn = GUILayout.Toggle(isShown, $"{row.Name} ({row.AvatarIndex})", EditorStyles.miniButton, GUILayout.Width(NameWidth));
                EditorGUILayout.LabelField(row.Summary, StyleOf(row.Severity));
                return isOn && !isShown;
            }
        }

        public static void Message(Severity severity, string text)
        {
            if (text.Length > 0)
                EditorGUILayout.HelpBox(text, TypeOf(severity));
        }

        public static Color ColorOf(Severity severity, bool isDarkSkin) => severity switch
        {
            Severity.Good => isDarkSkin ? new Color(0.40f, 0.85f, 0.45f) : new Color(0.05f, 0.45f, 0.10f),
            Severity.Waiting => isDarkSkin ? new Color(0.45f, 0.70f, 1.00f) : new Color(0.05f, 0.30f, 0.70f),
            Severity.Warning => isDarkSkin ? new Color(1.00f, 0.78f, 0.25f) : new Color(0.60f, 0.40f, 0.00f),
            Severity.Error => isDarkSkin ? new Color(1.00f, 0.45f, 0.40f) : new Color(0.75f, 0.08f, 0.05f),
            _ => isDarkSkin ? new Color(0.77f, 0.77f, 0.77f) : new Color(0.09f, 0.09f, 0.09f),
        };

        private static void DrawDot(Severity severity) =>
            EditorGUILayout.LabelField(Dot, StyleOf(severity), GUILayout.Width(DotWidth));

        private static MessageType TypeOf(Severity severity) => severity switch
        {
            Severity.Error => MessageType.Error,
            Severity.Warning => MessageType.Warning,
            _ => MessageType.Info,
        };

        private static GUIStyle StyleOf(Severity severity)
        {
            var key = (severity, EditorGUIUtility.isProSkin);
            if (!Styles.TryGetValue(key, out GUIStyle? style))
            {
                style = new GUIStyle(EditorStyles.label);
                style.normal.textColor = ColorOf(severity, EditorGUIUtility.isProSkin);
                Styles.Add(key, style);
            }

            return style;
        }
    }
}
