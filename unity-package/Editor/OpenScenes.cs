#nullable enable

using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace NeuronMocap.Unity.EditorTools
{
    // The scenes that the user sees: the open ones, and that of the prefab that is being edited. Unity and other tools keep hidden scenes for previews.
    internal static class OpenScenes
    {
        public static bool Contains(Component component)
        {
            if (EditorUtility.IsPersistent(component))
                return false;

            Scene scene = component.gameObject.scene;
            return scene.IsValid() && (!EditorSceneManager.IsPreviewScene(scene) || IsEdited(scene));
        }

        // Creates an object where Unity's own menus would. The name of the undo step is that of the object.
        public static GameObject Create(string name, GameObject? parent = null)
        {
            var created = new GameObject(name);
            StageUtility.PlaceGameObjectInCurrentStage(created);
            GameObjectUtility.SetParentAndAlign(created, parent);
            Undo.RegisterCreatedObjectUndo(created, $"Create {name}");
            return created;
        }

        // The prefab is in a preview scene, too.
        private static bool IsEdited(Scene scene)
        {
            PrefabStage? stage = PrefabStageUtility.GetCurrentPrefabStage();
            return stage != null && stage.scene == scene;
        }
    }
}
