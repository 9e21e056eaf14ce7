#nullable enable

using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Without Run In Background, a game stands still while Axis Neuron or another program has the focus.
    internal static class BackgroundAdvice
    {
        public const string Button = "Switch Run In Background On";

        private const string Message =
            "Run In Background is off in the player settings (Resolution and Presentation). The game then stands still while another program has the "
            + "focus, such as the mocap software.";

        public static void Draw()
        {
            if (PlayerSettings.runInBackground)
                return;

            EditorGUILayout.HelpBox(Message, MessageType.Warning);
            if (!GUILayout.Button(Button))
                return;

            // The first is for the next start, and the second for a game that runs.
            PlayerSettings.runInBackground = true;
            Application.runInBackground = true;
        }
    }
}
