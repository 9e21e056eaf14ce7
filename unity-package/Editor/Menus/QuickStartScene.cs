#nullable enable

using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Creates a source, a figure and a stage in the open scene. In play mode the figure moves without a suit. Existing sources and lights are reused.
    internal static class QuickStartScene
    {
        public static void Create()
        {
            MocapSource source = FindSource();
            GameObject figure = Make("Figure");
            HumanoidDriver driver = figure.AddComponent<HumanoidDriver>();
            driver.Source = source;
            figure.AddComponent<FigureBuilder>();

            GameObject stage = Make("Stage");
            StageBuilder builder = stage.AddComponent<StageBuilder>();
            builder.Target = figure.transform;
            builder.HasLight = !Has<Light>();
            Selection.activeGameObject = source.gameObject;
        }

        private static MocapSource FindSource()
        {
            if (SceneSources.Find() is { Count: > 0 } sources)
                return sources[0];

            MocapSource source = Make("Mocap Source").AddComponent<MocapSource>();
            source.Kind = SourceKind.Simulator;
            return source;
        }

        private static bool Has<T>()
            where T : Component
        {
            foreach (T found in Resources.FindObjectsOfTypeAll<T>())
            {
                if (!EditorUtility.IsPersistent(found) && found.gameObject.scene.IsValid())
                    return true;
            }

            return false;
        }

        private static GameObject Make(string name)
        {
            var made = new GameObject(name);
            Undo.RegisterCreatedObjectUndo(made, $"Create {name}");
            return made;
        }
    }
}
