#nullable enable

using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Starts and stops the preview of a source, in its inspector and in the Sources window.
    internal static class PreviewButton
    {
        public const string Label = "Preview";

        private static readonly GUIContent Content = new GUIContent(
            Label, "Connects now and moves the figures of this source without play mode. The scene is not changed: they return to their poses afterwards.");

        public static void Draw(MocapSource source)
        {
            if (Application.isPlaying)
                return;

            bool isOn = LivePreview.Includes(source);
            bool isWanted;
            using (new EditorGUI.DisabledScope(!isOn && !LivePreview.CanStart(source)))
                isWanted = GUILayout.Toggle(isOn, Content, EditorStyles.miniButton);

            if (isWanted && !isOn)
                LivePreview.Start(source);
            else if (isOn && !isWanted)
                LivePreview.Stop(source);
        }
    }
}
