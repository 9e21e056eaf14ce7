#nullable enable

using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Edit, Project Settings, NeuronMocap.
    internal static class SettingsPage
    {
        public const string Path = "Project/NeuronMocap";

        [SettingsProvider]
        public static SettingsProvider Create() => new SettingsProvider(Path, SettingsScope.Project)
        {
            label = "NeuronMocap",
            guiHandler = _ => Draw(NeuronMocapSettings.instance),
            keywords = new[] { "mocap", "motion capture", "network", "iOS", "tvOS", "visionOS", "Android", "WebGL", "permission" },
        };

        internal static void Draw(NeuronMocapSettings settings)
        {
            FieldDrawing.MakeEditable(settings);
            var serialized = new SerializedObject(settings);
            EditorGUILayout.LabelField("iOS, tvOS, visionOS", EditorStyles.boldLabel);
            SerializedProperty addText = serialized.FindProperty("_addLocalNetworkText");
            EditorGUILayout.PropertyField(addText, new GUIContent("Add Local Network Text"));
            using (new EditorGUI.DisabledScope(!addText.boolValue))
                EditorGUILayout.PropertyField(serialized.FindProperty("_localNetworkText"));
            if (addText.boolValue && string.IsNullOrWhiteSpace(settings.LocalNetworkText))
                EditorGUILayout.HelpBox(BuildRules.MissingTextAdvice, MessageType.Warning);

            EditorGUILayout.Space();
            EditorGUILayout.LabelField("Android", EditorStyles.boldLabel);
            EditorGUILayout.PropertyField(serialized.FindProperty("_requireInternetPermission"));
            EditorGUILayout.Space();
            EditorGUILayout.LabelField("WebGL", EditorStyles.boldLabel);
            EditorGUILayout.PropertyField(serialized.FindProperty("_webGL"), new GUIContent("Scenes With A Source"));
            if (serialized.ApplyModifiedProperties())
                settings.Save();
        }
    }
}
