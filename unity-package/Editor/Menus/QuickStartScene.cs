#nullable enable

using UnityEditor;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace NeuronMocap.Unity.EditorTools
{
    // Creates a source, a figure and a stage in the open scene. In play mode the figure moves without a suit. Existing sources, lights and cameras are
    // reused.
    internal static class QuickStartScene
    {
        // Beside the origin, where Unity puts a character that is dragged into the scene.
        private static readonly Vector3 FigurePosition = new Vector3(-1, 0, 0);

        // The main camera of Unity's scene templates. It sees the figure from behind, 10 m away.
        private static readonly Vector3 TemplatePosition = new Vector3(0, 1, -10);

        public static void Create()
        {
            GameObject figure = OpenScenes.Create("Figure");
            MocapSource source = FindSource(figure.scene);
            figure.transform.position = FigurePosition;
            HumanoidDriver driver = figure.AddComponent<HumanoidDriver>();
            driver.Source = source;
            figure.AddComponent<FigureBuilder>();

            GameObject stage = OpenScenes.Create("Stage");
            StageBuilder builder = stage.AddComponent<StageBuilder>();
            builder.Target = figure.transform;
            builder.HasLight = !Has<Light>();
            if (Camera.main is { } camera && camera != null && camera.gameObject.scene == figure.scene)
                Follow(camera, figure.transform);

            Selection.activeGameObject = source.gameObject;
        }

        private static MocapSource FindSource(Scene scene)
        {
            if (SceneSources.FirstIn(scene) is { } found)
                return found;

            MocapSource source = OpenScenes.Create("Mocap Source").AddComponent<MocapSource>();
            source.Kind = SourceKind.Simulator;
            return source;
        }

        // A camera that somebody has placed stays.
        private static void Follow(Camera camera, Transform figure)
        {
            // It follows another figure.
            if (camera.TryGetComponent(out FollowCamera _))
                return;

            Transform eye = camera.transform;
            if ((eye.position - TemplatePosition).magnitude > 0.01f || Quaternion.Angle(eye.rotation, Quaternion.identity) > 0.1f)
            {
                Debug.Log($"NeuronMocap: the camera '{camera.name}' stays as it is. Add the component Follow Camera to it to see the figure.", camera);
                return;
            }

            Undo.RecordObject(eye, "Place Camera");
            FollowCamera follow = Undo.AddComponent<FollowCamera>(camera.gameObject);
            follow.Target = figure;
            follow.Snap();
            PrefabUtility.RecordPrefabInstancePropertyModifications(eye);
        }

        private static bool Has<T>()
            where T : Component
        {
            foreach (T found in Resources.FindObjectsOfTypeAll<T>())
            {
                if (OpenScenes.Contains(found))
                    return true;
            }

            return false;
        }
    }
}
