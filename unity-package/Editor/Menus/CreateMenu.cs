#nullable enable

using System.Linq;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // The menu GameObject, NeuronMocap. Each item is a single undo step.
    internal static class CreateMenu
    {
        private const string Menu = "GameObject/NeuronMocap/";
        private const int Priority = 10;

        [MenuItem(Menu + "Source", false, Priority)]
        public static void CreateSource(MenuCommand command) => Create<MocapSource>("Mocap Source", command);

        [MenuItem(Menu + "Performer Spawner", false, Priority)]
        public static void CreateSpawner(MenuCommand command)
        {
            PerformerSpawner spawner = Create<PerformerSpawner>("Performer Spawner", command);
            spawner.Source = SceneSources.FirstIn(spawner.gameObject.scene);
        }

        [MenuItem(Menu + "Skeleton View", false, Priority)]
        public static void CreateView(MenuCommand command) => Create<SkeletonView>("Skeleton View", command);

        [MenuItem(Menu + "Performer Overlay", false, Priority)]
        public static void CreateOverlay(MenuCommand command) => Create<PerformerOverlay>("Performer Overlay", command);

        [MenuItem(Menu + "Humanoid Driver on Selection", false, Priority + 20)]
        public static void AddHumanoidDriver() => AddToSelection<HumanoidDriver>();

        [MenuItem(Menu + "Humanoid Driver on Selection", true)]
        public static bool CanAddHumanoidDriver() => Targets<HumanoidDriver>().Any(target => target.GetComponentInChildren<Animator>(true) != null);

        [MenuItem(Menu + "Generic Rig Driver on Selection", false, Priority + 20)]
        public static void AddGenericDriver() => AddToSelection<GenericRigDriver>();

        [MenuItem(Menu + "Generic Rig Driver on Selection", true)]
        public static bool CanAddGenericDriver() => Targets<GenericRigDriver>().Any();

        [MenuItem(Menu + "Add Colliders", false, Priority + 20)]
        public static void AddColliders()
        {
            foreach (FigureDriver driver in SelectedDrivers())
                ColliderCommand.Run(driver);
        }

        [MenuItem(Menu + "Add Colliders", true)]
        public static bool CanAddColliders() => SelectedDrivers().Length > 0;

        // Everything needed for a first look, in the open scene. Existing objects are not created again.
        [MenuItem(Menu + "Quick Start Scene", false, Priority + 40)]
        public static void CreateQuickStart()
        {
            Undo.SetCurrentGroupName("Create NeuronMocap Quick Start Scene");
            int group = Undo.GetCurrentGroup();
            QuickStartScene.Create();
            Undo.CollapseUndoOperations(group);
        }

        internal static T Create<T>(string name, MenuCommand? command)
            where T : Component
        {
            GameObject created = OpenScenes.Create(name, command?.context as GameObject);
            T component = created.AddComponent<T>();
            Selection.activeGameObject = created;
            return component;
        }

        private static FigureDriver[] SelectedDrivers() => Selection.gameObjects
            .Where(target => !EditorUtility.IsPersistent(target))
            .Select(target => target.GetComponent<FigureDriver>())
            .Where(driver => driver != null)
            .ToArray();

        private static GameObject[] Targets<T>()
            where T : Component =>
            Selection.gameObjects.Where(target => !EditorUtility.IsPersistent(target) && target.GetComponent<T>() == null).ToArray();

        private static void AddToSelection<T>()
            where T : Component
        {
            foreach (GameObject target in Targets<T>())
                Undo.AddComponent<T>(target);
        }
    }
}
